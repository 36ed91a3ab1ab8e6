// SPDX-License-Identifier: MIT
//
// Error: the answers beside the exact ones. Two errors, kept apart: against the exact answer of the bodies
// that the table holds (the algorithm's own error) and of the bodies as given (with the rounding of storage
// on top). Verdicts are wrong only outside the band where rounding decides; cases inside it are counted and
// shown apart.
#pragma once

#include <algorithm>

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class error final : public bench::Probe {
  public:
    using Answers = std::span<const measure::CheckedAnswer>;

    [[nodiscard]] std::string_view name() const override { return "error"; }
    [[nodiscard]] std::string_view summary() const override {
        return "worst error and wrong verdicts against exact arithmetic; steps, escapes, cycles, "
               "fallbacks and refinements";
    }

    [[nodiscard]] bench::Findings measure(const bench::ProbedCell& cell) const override {
        return {figures(cell.checked, cell.counts)};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(Answers answers,
                                                              const measure::AnswerCounts& counts) {
        const auto count = [&](auto is) {
            return static_cast<double>(std::count_if(answers.begin(), answers.end(), is));
        };
        using Answer = const measure::CheckedAnswer&;
        const double separated = count([](Answer a) { return a.separated; });
        const double touching = count([](Answer a) { return a.touching; });
        const double checked = static_cast<double>(answers.size());
        std::vector<measure::Figure> all = {
            store::figure("error.checked", checked),
            worst("error.worst_error_stored", answers, &measure::CheckedAnswer::error_stored),
            worst("error.worst_error_given", answers, &measure::CheckedAnswer::error_given),
            at_quantile("error.p99_error_stored", answers, &measure::CheckedAnswer::error_stored, 0.99),
            worst("error.witness_error", answers, &measure::CheckedAnswer::witness_error),
            store::figure("error.wrong_verdicts", count([](Answer a) { return a.verdict_wrong; })),
            store::figure("error.verdicts_in_band", count([](Answer a) { return a.in_band; })),
            store::figure("error.separated", separated),
            store::figure("error.touching", touching),
            store::figure("error.overlapping", checked - separated - touching),
            store::figure("error.fallbacks", static_cast<double>(counts.fallbacks)),
            store::figure("error.refinements", static_cast<double>(counts.refinements)),
            store::figure("error.escapes", static_cast<double>(counts.escapes)),
            store::figure("error.cycles", static_cast<double>(counts.cycles)),
            mean_steps(counts),
            store::figure("error.max_steps", static_cast<double>(counts.max_steps)),
        };
        add_control(answers, all);
        return all;
    }

  private:
    /// How often the paper's control disagrees: of checked answers, and of these outside the band.
    static void add_control(Answers answers, std::vector<measure::Figure>& all) {
        double asked = 0, disagrees = 0, outside = 0;
        for (const measure::CheckedAnswer& answer : answers) {
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

    static std::vector<double> column(Answers answers, double measure::CheckedAnswer::*error) {
        std::vector<double> result;
        for (const measure::CheckedAnswer& answer : answers) result.push_back(answer.*error);
        return result;
    }

    static measure::Figure worst(const store::FigureName& name, Answers answers,
                                 double measure::CheckedAnswer::*error) {
        return at_quantile(name, answers, error, 1.0);
    }

    static measure::Figure at_quantile(const store::FigureName& name, Answers answers,
                                       double measure::CheckedAnswer::*error, double p) {
        const auto value = measure::quantile(column(answers, error), p);
        if (value) return store::figure(name, value);
        return store::no_figure(name, "no query was checked", "check more queries");
    }

    static measure::Figure mean_steps(const measure::AnswerCounts& counts) {
        constexpr store::FigureName name("error.mean_steps");
        if (counts.queries == 0) return store::no_figure(name, "no query was asked", "");
        return store::figure(name, static_cast<double>(counts.steps) / static_cast<double>(counts.queries));
    }
};

}  // namespace edgewise::probes
