// SPDX-License-Identifier: MIT
//
// Compares the cache model with this machine's counters: random chases through memory of half to eight times
// each level's size, with the misses per load that are modelled and counted. If nothing can be counted, a row
// says why; the time per load shows the levels all the same.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/machine/machine.hpp"

namespace edgewise::measure {

struct CalibrationRow {
    std::string level;  ///< the level under test
    double times = 0;   ///< memory divided by the level's size
    std::uint64_t bytes = 0;
    std::optional<double> modelled = {};  ///< misses of the level, per load
    std::optional<double> counted = {};   ///< misses that the processor counted, per load
    std::string event = {}, reason = {};  ///< name of the counted event; why there is no count
    std::optional<double> ns = {};        ///< per load
};

struct CalibrationOptions {
    std::vector<double> times = {0.5, 1, 2, 8};
    std::uint64_t loads = 1'000'000;  ///< per pass
    std::uint64_t most_bytes = std::uint64_t{1} << 31;
};

/// Calibrates the machine's levels in turn; memory beyond most_bytes has a reason alone. `cpu`: this
/// machine's.
[[nodiscard]] std::vector<CalibrationRow> calibrate_model(const CacheMachine& machine, const Cpu& cpu,
                                                          const CalibrationOptions& options = {});

/// Loads at random, each address needing the value of the load before: no prefetcher foresees them and no
/// processor overlaps them. If memory has N lines and a cache C, N - C of N loads miss under every
/// replacement policy, so the misses show whether a model's sizes are those of the machine.
class RandomChase {
  public:
    static constexpr std::uint64_t line_bytes = 64;

    /// Takes `bytes` bytes of memory, whole lines, 2^32 lines at most. Throws std::bad_alloc.
    explicit RandomChase(std::uint64_t bytes)
        : lines_(bytes / line_bytes), memory_((lines_ + 1) * words_a_line, 0) {
        const auto address = reinterpret_cast<std::uintptr_t>(memory_.data());
        first_ = (line_bytes - address % line_bytes) % line_bytes / sizeof(std::uint64_t);
    }

    [[nodiscard]] std::uint64_t lines() const { return lines_; }

    /// Makes `loads` loads, from where the last call ended.
    void run(std::uint64_t loads) {
        const volatile std::uint64_t* const words = memory_.data() + first_;
        std::uint64_t loaded = 0;
        for (; loads > 0; --loads) {
            loaded = words[next(loaded) * words_a_line];
            state_ ^= loaded;
        }
    }

    /// Calls use(line) for the lines that run() would load, without loading any, from where the last call
    /// ended.
    template <class Use>
    void replay(std::uint64_t loads, Use use) {
        for (; loads > 0; --loads) use(next(0));
    }

  private:
    static constexpr std::uint64_t words_a_line = line_bytes / sizeof(std::uint64_t);

    /// Marsaglia, "Xorshift RNGs" (2003); the loaded value is always 0, but the processor does not know.
    std::uint64_t next(std::uint64_t loaded) {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return (((state_ + loaded) >> 32) * lines()) >> 32;
    }

    std::uint64_t lines_;
    std::vector<std::uint64_t> memory_;  ///< one line more than asked for, to begin at a line's start
    std::uint64_t first_ = 0;            ///< word where the first line starts
    std::uint64_t state_ = 88172645463325252;
};

// Latency of a load that each cache level answers on this machine: loads that depend on each other, over
// memory that fits the level but not the level above it.

/// Returns ns beyond a load that the first level answers, for each further level and then for memory; at
/// least zero. A level takes some milliseconds to measure, memory up to a second.
[[nodiscard]] std::vector<double> latencies_beyond_first(const CacheMachine& host);

}  // namespace edgewise::measure
