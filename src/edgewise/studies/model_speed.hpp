// SPDX-License-Identifier: MIT
//
// How fast the measuring itself is: accesses per second through the cache model and the reuse distances.
#pragma once

#include <string>
#include <vector>

#include "edgewise/studies/single_cell.hpp"

namespace edgewise::studies {

struct ModelSpeed {
    std::string what, trace;
    std::uint64_t accesses = 0;
    double per_second = 0;  ///< median of the repetitions
};

/// Measures a cell's own trace, kept in memory, and synthetic ones: all in the first level, and random over
/// 64 MiB. The model has the three levels of zen5.
[[nodiscard]] std::vector<ModelSpeed> model_speeds(const SingleCell& cell, int repetitions);

}  // namespace edgewise::studies
