// SPDX-License-Identifier: MIT
//
// Error: the answers against the exact ones. Two separate errors: against the exact answer of the bodies
// that the table holds (the algorithm's own error) and of the bodies as given (with the rounding of storage
// on top). Verdicts are wrong only outside the band where rounding decides; cases inside it are counted and
// shown separately.
#pragma once

#include <algorithm>
#include <string>

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class error {
  public:
    using Answers = std::span<const truth::CheckedAnswer>;

    static constexpr std::string_view summary =
        "worst error and wrong verdicts against exact arithmetic; steps, escapes, cycles, "
        "fallbacks and refinements";

    static constexpr bool of_peers = true;

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        return {figures(cell.checked, cell.counts)};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(Answers answers,
                                                              const bench::AnswerCounts& counts) {
        const auto count = [&](auto is) {
            return static_cast<double>(std::count_if(answers.begin(), answers.end(), is));
        };
        using Answer = const truth::CheckedAnswer&;
        const double separated = count([](Answer a) { return a.exact == truth::ExactVerdict::separated; });
        const double touching = count([](Answer a) { return a.exact == truth::ExactVerdict::touching; });
        const double checked = static_cast<double>(answers.size());
        std::vector<measure::Figure> all = {
            store::figure("error.checked", checked),
            at_quantile("error.worst_error_stored", answers, stored, 1.0),
            at_quantile("error.worst_error_given", answers, given, 1.0),
            at_quantile("error.p50_error_given", answers, given, 0.5),
            p999_given(answers),
            at_quantile("error.p99_error_stored", answers, stored, 0.99),
            at_quantile("error.witness_error", answers, &truth::CheckedAnswer::witness_error, 1.0),
            store::figure("error.wrong_verdicts", count([](Answer a) { return a.verdict_wrong; })),
            store::figure("error.wrong_answers", count([](Answer a) { return a.wrong(); })),
            store::figure("error.verdicts_in_band", count([](Answer a) { return a.in_band; })),
            store::figure("error.separated", separated),
            store::figure("error.touching", touching),
            store::figure("error.overlapping", checked - separated - touching),
            store::figure("error.fallbacks", counts.fallbacks),
            store::figure("error.refinements", counts.refinements),
            store::figure("error.escapes", counts.escapes),
            store::figure("error.cycles", counts.cycles),
        };
        add_steps(counts, all);
        add_control(answers, all);
        return all;
    }

    /// Checked answers that a p99.9 needs: of fewer not one answer is in the worst thousandth, and it would
    /// be read off the two largest errors.
    static constexpr std::size_t least_for_p999 = 1000;

  private:
    using Error = double truth::CheckedAnswer::*;
    static constexpr Error stored = &truth::CheckedAnswer::error, given = &truth::CheckedAnswer::error_given;

    static void add_steps(const bench::AnswerCounts& counts, std::vector<measure::Figure>& all) {
        const std::uint64_t warm = counts.warm, cold = counts.queries - warm;
        store::add_means(store::mean_steps,
                         {counts.steps, counts.steps - counts.warm_steps, counts.warm_steps},
                         {counts.queries, cold, warm}, all);
        const auto most = [](int steps, std::uint64_t queries) {
            return queries > 0 ? std::optional<double>(steps) : std::nullopt;
        };
        store::add_values(
            {"error.max_steps", "error.max_steps.{start}"},
            {counts.max_steps, most(counts.max_cold_steps, cold), most(counts.max_warm_steps, warm)}, all);
    }

    /// How often the paper's control disagrees: over checked answers, and over those outside the band.
    static void add_control(Answers answers, std::vector<measure::Figure>& all) {
        double asked = 0, disagrees = 0, outside = 0;
        for (const truth::CheckedAnswer& answer : answers) {
            if (!answer.control_disagrees) continue;
            ++asked;
            disagrees += *answer.control_disagrees;
            outside += *answer.control_disagrees && !answer.in_band;
        }
        const auto add = [&](const store::FigureName& name, double count) {
            if (asked > 0) return all.push_back(store::figure(name, count));
            all.push_back(
                store::no_figure(name, "the control was not asked", "a plan with control, such as paper"));
        };
        add("error.control_checked", asked);
        add("error.control_disagreements", disagrees);
        add("error.control_disagreements_outside_band", outside);
    }

    /// Returns the given error of each answer that has a distance, divided by the scale of its pair.
    static std::vector<double> column(Answers answers, Error error) {
        std::vector<double> result;
        for (const truth::CheckedAnswer& answer : answers)
            if (answer.has_distance) result.push_back(answer.band.over_scale(answer.*error));
        return result;
    }

    static measure::Figure p999_given(Answers answers) {
        const store::FigureName name("error.p999_error_given");
        const std::size_t known = column(answers, given).size();
        if (known >= least_for_p999) return at_quantile(name, answers, given, 0.999);
        return store::no_figure(
            name,
            "of " + std::to_string(known) + " checked distances a p99.9 would say no more than the worst",
            "check " + std::to_string(least_for_p999) + " queries or more (--checked)");
    }

    static measure::Figure at_quantile(const store::FigureName& name, Answers answers, Error error,
                                       double p) {
        return store::figure(name, measure::quantile(column(answers, error), p),
                             "no answer with a distance was checked",
                             "ask for distances, and check some (--checked)");
    }
};

}  // namespace edgewise::probes
