// SPDX-License-Identifier: MIT
//
// Time: nanoseconds a query, separated and contact pairs apart; medians over the interleaved rounds with a
// bootstrap interval; and the headline, the median ratio to the baseline cell timed in the same round.
#pragma once

#include "edgewise/measure/probe.hpp"
#include "edgewise/measure/statistics.hpp"

namespace edgewise::probes {

class time final : public measure::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "time"; }
    [[nodiscard]] std::string_view summary() const override {
        return "median ns a query with 95 % interval, and ratio to the baseline of the same rounds";
    }

    [[nodiscard]] std::vector<measure::Figure> figures(const measure::Subject& subject) const override {
        std::vector<measure::Figure> result;
        add(result, "separated", subject, &measure::Timing::separated_ns,
            &measure::Timing::separated_queries);
        add(result, "overlapping", subject, &measure::Timing::overlapping_ns,
            &measure::Timing::overlapping_queries);
        add_all(result, subject);
        result.push_back({"rounds", static_cast<double>(subject.rounds.size()), "rounds"});
        return result;
    }

  private:
    static double queries(const measure::Timing& timing) {
        return static_cast<double>(timing.separated_queries + timing.overlapping_queries);
    }

    /// Pairs of both kinds as they come, as the paper has them.
    static void add_all(std::vector<measure::Figure>& result, const measure::Subject& subject) {
        std::vector<double> each, baseline;
        for (const measure::Round& round : subject.rounds) {
            const double timed = queries(round.timing), beside = queries(round.baseline);
            if (timed == 0 || beside == 0) continue;
            each.push_back((round.timing.separated_ns + round.timing.overlapping_ns) / timed);
            baseline.push_back((round.baseline.separated_ns + round.baseline.overlapping_ns) / beside);
        }
        add_times(result, "all", each, baseline,
                  subject.rounds.empty() ? "no round was timed" : "no query was timed");
    }

    using Total = double measure::Timing::*;
    using Count = std::uint64_t measure::Timing::*;

    static void add(std::vector<measure::Figure>& result, const std::string& kind,
                    const measure::Subject& subject, Total total, Count count) {
        std::vector<double> each, baseline;
        for (const measure::Round& round : subject.rounds) {
            if (round.timing.*count == 0 || round.baseline.*count == 0) continue;
            each.push_back(round.timing.*total / static_cast<double>(round.timing.*count));
            baseline.push_back(round.baseline.*total / static_cast<double>(round.baseline.*count));
        }
        add_times(result, kind, each, baseline,
                  subject.rounds.empty() ? "no round was timed" : "the cell has no " + kind + " pair");
    }

    /// `none`: why there is no time at all.
    static void add_times(std::vector<measure::Figure>& result, const std::string& kind,
                          const std::vector<double>& each, const std::vector<double>& baseline,
                          const std::string& none) {
        const std::string reason = each.empty() ? none : "too few rounds for an interval";
        const std::string remedy =
            each.empty() ? "ask for more queries, or run the sweep again: it resumes" : "ask for more rounds";
        const auto figure = [&](const std::string& name, std::optional<double> value, const char* unit) {
            result.push_back(value ? measure::Figure{kind + name, value, unit}
                                   : measure::Figure{kind + name, std::nullopt, unit, reason, remedy});
        };
        const auto interval = measure::bootstrap_median(each);
        figure("_ns", measure::median(each), "ns");
        figure("_ns_low", interval ? std::optional(interval->lower) : std::nullopt, "ns");
        figure("_ns_high", interval ? std::optional(interval->upper) : std::nullopt, "ns");
        figure("_ratio", measure::median(measure::paired_ratios(each, baseline)), "1");
    }
};

}  // namespace edgewise::probes
