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

/// Throws std::invalid_argument if the scene cannot be made.
[[nodiscard]] scene::Workload workload_of(const Scene& scene);

/// Sizes at which a demand is known, in ascending order.
struct MemorySizes {
    std::vector<std::uint64_t> lines, pages;
};

/// Numbers per query of the counted steps, with the first queries of pairs.
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

/// `filling`: number of steps before the counted steps.
[[nodiscard]] MemoryDemand trace_demand(const bench::TableType& type, const std::string& algorithm,
                                        const scene::Workload& workload, bench::Sharing sharing,
                                        const MemorySizes& sizes, std::size_t filling);

// Time of a query on a processor of the paper's time with too little memory:
//
//     t = reads x k + sum over levels of misses x latency + TLB misses x walk + faults x c
//
// k is the processor's time for each read of a field with all data in its first cache: one number per machine
// and time step, fitted so that the tops of figures 4, 6 and 7 (without thrashing, says the paper) are met on
// average. Reads measure the processor's work: unlike instructions, they can be counted in every cell. The
// caches are fully associative LRU: exact for any size, with slightly fewer misses than real ones.

/// One of measure/machines with lines of 32 bytes and two levels.
class OldMachine {
  public:
    /// Throws std::invalid_argument if the machine has other lines or levels, or no known latencies.
    explicit OldMachine(const measure::CacheMachine& machine);

    [[nodiscard]] const std::string& name() const { return machine_->name; }
    [[nodiscard]] double ns_of_cycles(double cycles) const { return cycles * 1000 / machine_->clock_mhz; }
    [[nodiscard]] std::uint64_t lines(std::size_t level) const;
    [[nodiscard]] std::uint64_t tlb_pages() const;

    /// Return the latency of an answer, minus the latency of the first level.
    [[nodiscard]] double second_level_ns() const;
    [[nodiscard]] double memory_ns() const;
    /// Returns the time of a page walk: it reads two tables (32-bit processors), assumed in the second level.
    [[nodiscard]] double walk_ns() const { return 2 * second_level_ns(); }

    /// Returns the time of misses: `first` and `second` of the two levels, `tlb` of the TLB.
    [[nodiscard]] double memory_time_ns(double first, double second, double tlb) const {
        return (first - second) * second_level_ns() + second * memory_ns() + tlb * walk_ns();
    }

  private:
    const measure::CacheMachine* machine_;
};

/// Returns the factorial's machines, from measure/machines: older than the paper, written in 2000 or 2001.
[[nodiscard]] std::vector<OldMachine> old_machines();

/// Returns the sizes of the machines' caches and TLBs, and the sizes in `memories` (bytes).
[[nodiscard]] MemorySizes sizes_for(const std::vector<OldMachine>& machines,
                                    const std::vector<std::uint64_t>& memories);

/// Returns the misses of a demand at one of its sizes.
[[nodiscard]] double misses_at(const std::vector<std::uint64_t>& sizes, const std::vector<double>& misses,
                               std::uint64_t size);

/// Returns the time of a query's misses in caches and TLB.
[[nodiscard]] double cache_ns(const OldMachine& machine, const MemorySizes& sizes,
                              const MemoryDemand& demand);

/// The end of a figure's time axis, and the reads and memory time of the slower algorithm there.
struct CalibrationPoint {
    int figure = 0;
    double top_ns = 0;
    double reads = 0, memory_ns = 0;

    [[nodiscard]] double model_ns(double ns_per_read) const { return reads * ns_per_read + memory_ns; }
};

/// Returns k, for which the mean of log(model over top) is 0; 0 if memory alone takes longer.
[[nodiscard]] double ns_per_read(const std::vector<CalibrationPoint>& points);

}  // namespace edgewise::studies::thrash
