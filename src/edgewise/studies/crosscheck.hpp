// SPDX-License-Identifier: MIT
//
// A cell's modelled misses beside those that outside tools count of the same queries: Callgrind, which
// simulates the whole program, and `perf stat`, which asks the processor. The model knows tables and pair
// caches; a pass also reads its queries' poses, one after the other, which can be added to the model. What is
// left (the stack, answers) only the tools see, and that residual is reported.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edgewise/measure/expected.hpp"
#include "edgewise/measure/machine/cpu.hpp"
#include "edgewise/studies/callgrind_pass.hpp"

namespace edgewise::studies {

/// One pass over the cell's queries, after another one; it knows no instructions. with_poses: the list of
/// queries is memory too.
[[nodiscard]] measure::CallgrindCounts model_pass(const SingleCell& cell,
                                                  const measure::CacheGeometry& geometry, bool with_poses);

/// The geometry less the ways of the first level's sets that the stack and constants may keep for themselves:
/// two, or one where sets have but two. By inclusion of least-recently-used caches, whatever lies in those
/// ways, the tables' lines miss no more often than in this one. Unknown: the sets have one way.
[[nodiscard]] measure::Expected<measure::CacheGeometry> without_ways_of_the_stack(
    measure::CacheGeometry geometry);

/// An event as `perf stat` counts it over one pass in user mode: the difference of many passes and one, so
/// that all else falls out.
struct PerfCount {
    std::string event, encoding;
    std::optional<std::string> level;  ///< what it counts here
    measure::Expected<double> count;
};
/// Instructions and misses by level, by the encodings that `edgewise machine` tells; unknown where this
/// machine does not count them, or perf does not all the time.
[[nodiscard]] std::vector<PerfCount> perf_pass(const CellChoice& choice, const std::string& program,
                                               const measure::Cpu& cpu);

}  // namespace edgewise::studies
