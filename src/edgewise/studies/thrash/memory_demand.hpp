// SPDX-License-Identifier: MIT
//
// What one scene's queries ask of memories of any size: a trace in time order through exact reuse distances
// (reuse_distance.hpp), of lines of 32 bytes as the processors of the paper's time had them, and of pages of
// 4 KiB. Everything counts that a step reads and writes: tables, the caches of pairs, the broad phase's
// arrays. Some steps fill the memory, those after them count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/bench/runner_options.hpp"
#include "edgewise/measure/cache/reuse_distance.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::studies::thrash {

inline constexpr std::uint64_t line_bytes = 32, page_bytes = 4096;

/// Bodies of one shape that tumble, as in the paper's figures 4 and 6 to 8.
struct Scene {
    std::string shape;
    std::size_t bodies = 0;
    double rotation_step = 0;       ///< rad
    double step_in_dimensions = 0;  ///< way of a step over the smallest dimension
    std::size_t steps = 0;
    std::uint64_t seed = 1;
};

/// Throws std::invalid_argument where the scene cannot be made.
[[nodiscard]] scene::Workload workload_of(const Scene& scene);

/// Sizes at which a demand is known, growing.
struct MemorySizes {
    std::vector<std::uint64_t> lines, pages;
};

/// Per query of the counted steps, first queries of pairs included.
struct MemoryDemand {
    std::uint64_t queries = 0, steps = 0;
    double reads = 0;                              ///< of fields and of pairs' caches: the processor's work
    std::vector<double> line_misses, page_misses;  ///< by size, as MemorySizes has them; LRU; no first uses
    double pages = 0;   ///< distinct in the whole run, of everything; not per query
    double cycles = 0;  ///< that V-Clip ran into, of all queries traced; a count
    double lines_of_a_step = 0, pages_of_a_step = 0;  ///< distinct ones of a step, summed, per query
    double table_bytes = 0;                           ///< of one body's table
    double tables = 0;                                ///< number of tables
    std::string reason;                               ///< why there is none of this
};

/// `filling`: steps before those that count.
[[nodiscard]] MemoryDemand trace_demand(const bench::TableType& type, const std::string& algorithm,
                                        const scene::Workload& workload, bench::Sharing sharing,
                                        const MemorySizes& sizes, std::size_t filling);

}  // namespace edgewise::studies::thrash
