// SPDX-License-Identifier: MIT
//
// Time: nanoseconds per query, of separated pairs and of pairs in contact; medians over the interleaved
// rounds with a bootstrap interval; and the headline, the median ratio to the baseline cell timed in the same
// round. Where pairs are followed, all of them are of queries that start warm; a pair's first query has a
// figure of its own (time.query_ns).
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class time {
  public:
    static constexpr std::string_view summary =
        "median ns per query with 95 % interval, and ratio to the baseline of the same rounds";

    static constexpr bool of_peers = true;

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        return {figures(cell.rounds, cell.workload.warm)};
    }

    /// warm: pairs are followed.
    [[nodiscard]] static std::vector<measure::Figure> figures(std::span<const measure::Round> rounds,
                                                              bool warm) {
        std::vector<measure::Figure> result;
        add(result, store::separated_time, rounds, &measure::Timing::separated,
            "the cell has no separated pair");
        add(result, store::overlapping_time, rounds, &measure::Timing::overlapping,
            "the cell has no overlapping pair");
        add(result, store::all_time, rounds, &measure::Timing::all, "no query was timed");
        add_by_start(result, rounds, warm);
        result.push_back(store::figure("time.rounds", rounds.size()));
        return result;
    }

  private:
    static void add_by_start(std::vector<measure::Figure>& result, std::span<const measure::Round> rounds,
                             bool warm) {
        using Times = measure::ByStart<std::optional<double>>;
        const auto median = [&](std::optional<double> Times::*start) {
            std::vector<double> each;
            for (const measure::Round& round : rounds)
                if (const auto ns = round.timing.by_start(warm).*start) each.push_back(*ns);
            return measure::median(each);
        };
        store::add_values(store::query_time,
                          {median(&Times::all), median(&Times::cold), median(&Times::warm)}, result);
    }

    /// `none`: why no round has such queries.
    static void add(std::vector<measure::Figure>& result, const store::QueryTime& names,
                    std::span<const measure::Round> rounds, measure::PerQuery per_query, const char* none) {
        std::vector<double> each, paired, baseline;
        for (const measure::Round& round : rounds) {
            const auto own = (round.timing.*per_query)(), beside = (round.baseline.*per_query)();
            if (own) each.push_back(*own);
            if (!own || !beside) continue;
            paired.push_back(*own);
            baseline.push_back(*beside);
        }
        const bool untold = !rounds.empty() && rounds.front().timing.either_queries > 0;
        const std::string reason = rounds.empty() ? "no round was timed"
                                   : each.empty() && untold
                                       ? "the queries asked for do not distinguish this kind of pair"
                                   : each.empty() ? none
                                                  : "too few rounds for an interval";
        const std::string remedy = each.empty() && untold ? "look at all pairs, or at a cell that needs more"
                                   : each.empty() ? "ask for more queries, or run the sweep again: it resumes"
                                                  : "ask for more rounds";
        const auto figure = [&](const store::FigureName& name, std::optional<double> value) {
            result.push_back(store::figure(name, value, reason, remedy));
        };
        const auto interval = measure::bootstrap_median(each);
        figure(names.ns, measure::median(each));
        figure(names.low, interval ? std::optional(interval->lower) : std::nullopt);
        figure(names.high, interval ? std::optional(interval->upper) : std::nullopt);
        result.push_back(store::figure(names.ratio, measure::median(measure::paired_ratios(paired, baseline)),
                                       each.empty() ? reason : "the baseline has no such query", remedy));
    }
};

}  // namespace edgewise::probes
