// SPDX-License-Identifier: MIT
//
// The time of a query under one setting of the factorial: the demand of its scene, and what the mechanism
// adds.
#pragma once

#include "edgewise/studies/thrash/factorial.hpp"

namespace edgewise::studies::thrash {

/// What a time depends on.
struct TimedScene {
    const OldMachine* machine = nullptr;
    const MemorySizes* sizes = nullptr;
    const MemoryDemand* demand = nullptr;
    double ns_per_read = 0;
    double build_reads = 0;                   ///< of a table, in reads' worth of time
    bool is_vclip = false, is_large = false;  ///< of 386 vertices
};

/// Arithmetic of turning 32 bytes, a plane of four doubles, to world space: 21 operations, one per cycle of a
/// processor of the time.
inline constexpr double cycles_per_turned_line = 21;
/// Reads of a feature step of V-Clip: about the 228 of a slow query of 386 vertices over its 3 to 4 steps.
inline constexpr double reads_per_feature_step = 60;
/// Iterations that the paper's times of one point are means of.
inline constexpr double papers_iterations = 30000;

/// ns per query.
[[nodiscard]] double query_ns(const TimedScene& scene, const Setting& setting);

}  // namespace edgewise::studies::thrash
