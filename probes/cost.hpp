// SPDX-License-Identifier: MIT
//
// Cost of a step of the scene, as the paper's cost functions split it (section 1): N_v tests of bounding
// volumes at C_v each, N_p tests of primitives at C_p, N_u updates of bounding volumes at C_u.
//     equation 1: T = N_v C_v + N_p C_p        equation 2: the same + N_u C_u
// Next to these sums it gives the time that the whole step took. Times are medians of a few passes, each
// part timed alone; what a sum misses is what the parts do to each other's caches.
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

/// Means per step over the steps that have one before them. A volume is a body's box in world axes; a pair of
/// boxes is tested when sweep and prune compares their ends on the axis that it sweeps.
struct StepCosts {
    std::uint64_t steps = 0;                             ///< 0: not measured
    double bodies = 0;                                   ///< N_u
    double box_tests = 0;                                ///< N_v
    double pairs = 0;                                    ///< N_p
    double moves = 0;                                    ///< places that sorting moved
    double update_ns = 0, box_test_ns = 0, pair_ns = 0;  ///< C_u, C_v, C_p, each timed separately
    double step_ns = 0;                           ///< T: all of it, step after step, as an engine would
    std::string reason = "not measured", remedy;  ///< where steps is 0

    [[nodiscard]] double equation_1() const { return box_tests * box_test_ns + pairs * pair_ns; }
    [[nodiscard]] double equation_2() const { return equation_1() + bodies * update_ns; }
};

/// Costs of a scene in time order with boxes and poses in its frames; other scenes get only the reason.
/// Medians of a few passes over all steps; the first step of a population, where nothing is known from
/// before, is run and not counted.
[[nodiscard]] StepCosts step_costs(const bench::Runner& runner, const scene::Workload& workload);

class cost {
  public:
    static constexpr std::string_view summary =
        "a step's tests and times by part, and the paper's cost functions next to the whole";

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        StepCosts costs;
        if (!cell.plain) costs.reason = "measured for the cell without further axes";
        if (cell.plain && cell.verified) costs = step_costs(cell.runner, cell.workload);
        return {figures(costs)};
    }

    [[nodiscard]] static std::vector<measure::Figure> figures(const StepCosts& costs) {
        if (costs.steps == 0) return {store::no_figure("cost.step_ns", costs.reason, costs.remedy)};
        return {
            store::figure("cost.steps", costs.steps),
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
