// SPDX-License-Identifier: MIT
//
// What a step of the scene costs, split as the paper's cost functions split it (measure/step_costs.hpp), and
// their sums beside the time that the whole step really took. Times are medians of a few passes, each part
// timed alone; what a sum misses is what the parts do to each other's caches.
#pragma once

#include "edgewise/measure/probe.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class cost final : public measure::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "cost"; }
    [[nodiscard]] std::string_view summary() const override {
        return "a step's tests and times by part, and the paper's cost functions beside the whole";
    }

    [[nodiscard]] std::vector<measure::Figure> figures(const measure::Subject& subject) const override {
        const measure::StepCosts& costs = subject.costs;
        if (costs.steps == 0) return {store::no_figure("cost.step_ns", costs.reason, costs.remedy)};
        return {
            store::figure("cost.steps", static_cast<double>(costs.steps)),
            store::figure("cost.bodies", costs.bodies),
            store::figure("cost.pairs_per_step", costs.pairs),
            store::figure("cost.all_pairs", costs.bodies * (costs.bodies - 1) / 2),
            store::figure("cost.box_tests_per_step", costs.box_tests),
            store::figure("cost.moves_per_step", costs.moves),
            store::figure("cost.update_ns", costs.update_ns),
            store::figure("cost.box_test_ns", costs.box_test_ns),
            store::figure("cost.pair_ns", costs.pair_ns),
            store::figure("cost.step_ns", costs.step_ns),
            store::figure("cost.equation_1_ns", costs.equation_1()),
            store::figure("cost.equation_2_ns", costs.equation_2()),
            store::figure("cost.equation_1_ratio", costs.equation_1() / costs.step_ns),
            store::figure("cost.equation_2_ratio", costs.equation_2() / costs.step_ns),
        };
    }
};

}  // namespace edgewise::probes
