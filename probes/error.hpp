// SPDX-License-Identifier: MIT
//
// Error: the answers beside the exact ones. Two errors, kept apart: against the exact answer of the bodies
// that the table holds (the algorithm's own error) and of the bodies as given (with the rounding of storage
// on top). Verdicts are wrong only outside the band where rounding decides; cases inside it are counted and
// shown apart.
#pragma once

#include <algorithm>

#include "edgewise/measure/probe.hpp"
#include "edgewise/measure/statistics.hpp"

namespace edgewise::probes {

class error final : public measure::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "error"; }
    [[nodiscard]] std::string_view summary() const override {
        return "worst error and wrong verdicts against exact arithmetic; steps, escapes, cycles, "
               "fallbacks and refinements";
    }

    [[nodiscard]] std::vector<measure::Figure> figures(const measure::Subject& subject) const override {
        const auto count = [&](auto is) {
            return static_cast<double>(std::count_if(subject.checked.begin(), subject.checked.end(), is));
        };
        using Answer = const measure::CheckedAnswer&;
        const double separated = count([](Answer a) { return a.separated; });
        const double touching = count([](Answer a) { return a.touching; });
        const double checked = static_cast<double>(subject.checked.size());
        const measure::AnswerCounts& counts = subject.counts;
        std::vector<measure::Figure> all = {
            {"checked", checked, "queries"},
            worst("worst_error_stored", subject, &measure::CheckedAnswer::error_stored),
            worst("worst_error_given", subject, &measure::CheckedAnswer::error_given),
            at_quantile("p99_error_stored", subject, &measure::CheckedAnswer::error_stored, 0.99),
            worst("witness_error", subject, &measure::CheckedAnswer::witness_error),
            {"wrong_verdicts", count([](Answer a) { return a.verdict_wrong; }), "queries"},
            {"verdicts_in_band", count([](Answer a) { return a.in_band; }), "queries"},
            {"separated", separated, "queries"},
            {"touching", touching, "queries"},
            {"overlapping", checked - separated - touching, "queries"},
            {"fallbacks", static_cast<double>(counts.fallbacks), "queries"},
            {"refinements", static_cast<double>(counts.refinements), "queries"},
            {"escapes", static_cast<double>(counts.escapes), "escapes"},
            {"cycles", static_cast<double>(counts.cycles), "queries"},
            mean_steps(counts),
            {"max_steps", static_cast<double>(counts.max_steps), "steps"},
        };
        add_control(subject, all);
        return all;
    }

  private:
    /// How often the paper's control disagrees: of checked answers, and of these outside the band.
    static void add_control(const measure::Subject& subject, std::vector<measure::Figure>& all) {
        double asked = 0, disagrees = 0, outside = 0;
        for (const measure::CheckedAnswer& answer : subject.checked) {
            if (!answer.control_disagrees) continue;
            ++asked;
            disagrees += *answer.control_disagrees;
            outside += *answer.control_disagrees && !answer.in_band;
        }
        const auto add = [&](const char* name, double count) {
            if (asked > 0) return all.push_back({name, count, "queries"});
            all.push_back({name, std::nullopt, "queries", "the control was not asked",
                           "a plan with control, such as paper"});
        };
        add("control_checked", asked);
        add("control_disagreements", disagrees);
        add("control_disagreements_outside_band", outside);
    }

    static std::vector<double> column(const measure::Subject& subject,
                                      double measure::CheckedAnswer::*error) {
        std::vector<double> result;
        for (const measure::CheckedAnswer& answer : subject.checked) result.push_back(answer.*error);
        return result;
    }

    static measure::Figure worst(const char* name, const measure::Subject& subject,
                                 double measure::CheckedAnswer::*error) {
        return at_quantile(name, subject, error, 1.0);
    }

    static measure::Figure at_quantile(const char* name, const measure::Subject& subject,
                                       double measure::CheckedAnswer::*error, double p) {
        const auto value = measure::quantile(column(subject, error), p);
        if (value) return {name, value, "scale"};
        return {name, std::nullopt, "scale", "no query was checked", "check more queries"};
    }

    static measure::Figure mean_steps(const measure::AnswerCounts& counts) {
        if (counts.queries == 0) return {"mean_steps", std::nullopt, "steps", "no query was asked", ""};
        return {"mean_steps", static_cast<double>(counts.steps) / static_cast<double>(counts.queries),
                "steps"};
    }
};

}  // namespace edgewise::probes
