// SPDX-License-Identifier: MIT
//
// What a step of the scene costs, split as the paper's cost functions split it (measure/step_costs.hpp), and
// their sums beside the time that the whole step really took. Times are medians of a few passes, each part
// timed alone; what a sum misses is what the parts do to each other's caches.
#pragma once

#include "edgewise/measure/probe.hpp"

namespace edgewise::probes {

class cost final : public measure::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "cost"; }
    [[nodiscard]] std::string_view summary() const override {
        return "a step's tests and times by part, and the paper's cost functions beside the whole";
    }

    [[nodiscard]] std::vector<measure::Figure> figures(const measure::Subject& subject) const override {
        const measure::StepCosts& costs = subject.costs;
        if (costs.steps == 0) return {{"step_ns", std::nullopt, "ns", costs.reason, costs.remedy}};
        return {
            {"steps", static_cast<double>(costs.steps), "steps"},
            {"bodies", costs.bodies, "bodies"},
            {"pairs_per_step", costs.pairs, "pairs"},
            {"all_pairs", costs.bodies * (costs.bodies - 1) / 2, "pairs"},
            {"box_tests_per_step", costs.box_tests, "tests"},
            {"moves_per_step", costs.moves, "moves"},
            {"update_ns", costs.update_ns, "ns"},
            {"box_test_ns", costs.box_test_ns, "ns"},
            {"pair_ns", costs.pair_ns, "ns"},
            {"step_ns", costs.step_ns, "ns"},
            {"equation_1_ns", costs.equation_1(), "ns"},
            {"equation_2_ns", costs.equation_2(), "ns"},
            {"equation_1_ratio", costs.equation_1() / costs.step_ns, "1"},
            {"equation_2_ratio", costs.equation_2() / costs.step_ns, "1"},
        };
    }
};

}  // namespace edgewise::probes
