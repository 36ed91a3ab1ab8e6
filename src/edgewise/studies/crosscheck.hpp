// SPDX-License-Identifier: MIT
//
// Compares a cell's modelled misses with those that outside tools count for the same queries: Callgrind,
// which simulates the whole program, and `perf stat`, which reads the processor's counters. The model knows
// tables and pair caches; a pass also reads its queries' poses in order, which can be added to the model.
// Only the tools see the rest (the stack, answers); that residual is reported.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edgewise/measure/expected.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/studies/effort/effort.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::studies {

/// Models one pass over the cell's queries, after another one; it counts no instructions. with_poses: the
/// list of queries is memory too.
[[nodiscard]] measure::CallgrindCounts model_pass(const SingleCell& cell,
                                                  const measure::CacheGeometry& geometry, bool with_poses);

/// Returns the geometry with fewer ways per set, which other things may take: in the first level the stack
/// and constants, two ways or one of two; in the last level these and the program's instructions, one way.
/// By inclusion of least-recently-used caches, whatever lies in these ways, the tables' lines miss no more
/// often than in this cache. Unknown if sets of the first level have one way.
[[nodiscard]] measure::Expected<measure::CacheGeometry> without_ways_of_the_stack(
    measure::CacheGeometry geometry);

/// An event as `perf stat` counts it over one pass in user mode: the difference between many passes and one,
/// so that everything outside a pass cancels.
struct PerfCount {
    std::string event, encoding;
    std::optional<std::string> level;  ///< what it counts here
    measure::Expected<double> count;
};
/// Counts instructions and misses by level, by the encodings that `edgewise machine` prints; unknown if this
/// machine does not count an event, or perf does not count it all the time.
[[nodiscard]] std::vector<PerfCount> perf_pass(const CellChoice& choice, const std::string& program,
                                               const measure::Cpu& cpu);

// How fast the measuring itself is: accesses per second through the cache model and the reuse distances.

struct ModelSpeed {
    std::string what, trace;
    std::uint64_t accesses = 0;
    double accesses_per_second = 0;  ///< median of the repetitions
};

/// Measures a cell's own trace, kept in memory, and synthetic ones: all in the first level, and random over
/// 64 MiB. The model has the three levels of zen5.
[[nodiscard]] std::vector<ModelSpeed> model_speeds(const SingleCell& cell, int repetitions);

}  // namespace edgewise::studies
