// SPDX-License-Identifier: MIT
//
// Memory demand of one scene's queries for any memory size: a trace in time order through reuse distances
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
#include "edgewise/measure/cache/cache_machine.hpp"
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

// Time of a query on a processor of the paper's time with too little memory:
//
//     t = reads x k + sum over levels of misses x latency + TLB misses x walk + faults x c
//
// k is the processor's time for each read of a field, everything in its first cache: one number per machine
// and time step, such that the tops of figures 4, 6 and 7 (no thrash there, says the paper) are met on
// average. Reads measure the processor's work: unlike instructions they can be counted in every cell. The
// caches are fully associative LRU here: exact for any size, a little kind to the real ones.

/// One of measure/machines with lines of 32 bytes and two levels.
class OldMachine {
  public:
    /// Throws std::invalid_argument for one that has other lines or levels, or no known latencies.
    explicit OldMachine(const measure::CacheMachine& machine);

    [[nodiscard]] const std::string& name() const { return machine_->name; }
    [[nodiscard]] double ns_of_cycles(double cycles) const { return cycles * 1000 / machine_->clock_mhz; }
    [[nodiscard]] std::uint64_t lines(std::size_t level) const;
    [[nodiscard]] std::uint64_t tlb_pages() const;

    /// To an answer, beyond one of the first level.
    [[nodiscard]] double second_level_ns() const;
    [[nodiscard]] double memory_ns() const;
    /// A page walk reads two tables, as 32-bit processors have them: from the second level, assumed.
    [[nodiscard]] double walk_ns() const { return 2 * second_level_ns(); }

    /// Returns the time of these misses of the first level, the second and the TLB.
    [[nodiscard]] double memory_time_ns(double first, double second, double tlb) const {
        return (first - second) * second_level_ns() + second * memory_ns() + tlb * walk_ns();
    }

  private:
    const measure::CacheMachine* machine_;
};

/// Those of the factorial, of measure/machines: the text was written in 2000 or 2001 of experiments before.
[[nodiscard]] std::vector<OldMachine> old_machines();

/// Returns the sizes of the caches and TLBs, and of memories of these bytes.
[[nodiscard]] MemorySizes sizes_for(const std::vector<OldMachine>& machines,
                                    const std::vector<std::uint64_t>& memories);

/// A demand's misses at one of its sizes.
[[nodiscard]] double misses_at(const std::vector<std::uint64_t>& sizes, const std::vector<double>& misses,
                               std::uint64_t size);

/// The term of caches and TLB of a query.
[[nodiscard]] double cache_ns(const OldMachine& machine, const MemorySizes& sizes,
                              const MemoryDemand& demand);

/// A figure's end of the axis of time, and what is asked there by the algorithm that takes longer.
struct CalibrationPoint {
    int figure = 0;
    double top_ns = 0;
    double reads = 0, memory_ns = 0;

    [[nodiscard]] double model_ns(double ns_per_read) const { return reads * ns_per_read + memory_ns; }
};

/// k: the mean of log(model over top) is 0; 0 where memory alone takes longer than that.
[[nodiscard]] double ns_per_read(const std::vector<CalibrationPoint>& points);

}  // namespace edgewise::studies::thrash
