// SPDX-License-Identifier: MIT
//
// What a query takes on a processor of the paper's time with too little memory:
//
//     t = reads x k + sum over levels of misses x latency + TLB misses x walk + faults x c
//
// k is the processor's time for each read of a field, everything in its first cache: one number per machine
// and time step, such that the tops of figures 4, 6 and 7 (no thrash there, says the paper) are met on
// average. Reads stand for the processor's work: unlike instructions they can be counted in every cell. The
// caches are fully associative LRU here: exact for any size, a little kind to the real ones.
#pragma once

#include <string>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/studies/thrash/memory_demand.hpp"

namespace edgewise::studies::thrash {

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

    /// Of so many misses of the first level, the second and the TLB.
    [[nodiscard]] double memory_time_ns(double first, double second, double tlb) const {
        return (first - second) * second_level_ns() + second * memory_ns() + tlb * walk_ns();
    }

  private:
    const measure::CacheMachine* machine_;
};

/// Those of the factorial, of measure/machines: the text was written in 2000 or 2001 of experiments before.
[[nodiscard]] std::vector<OldMachine> old_machines();

/// The caches' and TLBs' sizes, and memories of so many bytes.
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
