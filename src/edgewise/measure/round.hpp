// SPDX-License-Identifier: MIT
//
// One timed repetition of a cell, with the baseline cell timed beside it in the same round.
#pragma once

#include <cstdint>

namespace edgewise::measure {

struct Timing {
    std::uint64_t separated_queries = 0, overlapping_queries = 0;
    double separated_ns = 0, overlapping_ns = 0;  ///< total time of those queries, clock cost subtracted
};

struct Round {
    int number = 0;
    Timing timing;
    Timing baseline;  ///< of the same round
};

}  // namespace edgewise::measure
