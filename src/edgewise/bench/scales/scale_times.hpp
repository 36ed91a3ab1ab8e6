// SPDX-License-Identifier: MIT
//
// What was measured of one table at many scales (scale_study.hpp).
#pragma once

#include <cstddef>
#include <vector>

namespace edgewise::bench {

struct ScaleTimes {
    std::size_t scales = 0;                   ///< 0: the layout is not measured so
    std::vector<double> shared_ns, own_ns;    ///< of each repetition, per query
    std::vector<double> build_ns, refit_ns;   ///< of a table of a stretched body, from scratch and in place
    double shared_bytes = 0, own_bytes = 0;   ///< of tables, and of the objects that hold or view them
    std::size_t queries = 0, other_bits = 0;  ///< asked of both once; distances that differ
    std::size_t checked = 0;                  ///< of them, against exact ones
    double error = 0;                         ///< the worst, over the size of the problem
};

}  // namespace edgewise::bench
