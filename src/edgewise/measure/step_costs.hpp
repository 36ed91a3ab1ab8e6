// SPDX-License-Identifier: MIT
//
// What a step of a scene costs, as the paper's cost functions split it (section 1): N_v tests of bounding
// volumes at C_v each, N_p tests of primitives at C_p, N_u updates of bounding volumes at C_u.
//     equation 1: T = N_v C_v + N_p C_p        equation 2: the same + N_u C_u
#pragma once

#include <cstdint>
#include <string>

namespace edgewise::measure {

/// Means per step, over the steps that have one before them. A volume is a body's box in world axes; a pair
/// of boxes is tested when sweep and prune compares their ends on the axis that it sweeps.
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

}  // namespace edgewise::measure
