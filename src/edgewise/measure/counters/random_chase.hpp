// SPDX-License-Identifier: MIT
//
// Loads at random, each address needing the value of the load before: no prefetcher foresees them and no
// processor overlaps them. Of N lines and a cache of C, N - C in N miss whatever the replacement policy, so
// the misses show whether a model's sizes are those of the machine.
#pragma once

#include <cstdint>
#include <vector>

namespace edgewise::measure {

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

    /// So many loads; goes on where the last call ended.
    void run(std::uint64_t loads) {
        const volatile std::uint64_t* const words = memory_.data() + first_;
        std::uint64_t loaded = 0;
        for (; loads > 0; --loads) {
            loaded = words[next(loaded) * words_a_line];
            state_ ^= loaded;
        }
    }

    /// Tells use(line) of the lines that run() would load, without loading any; goes on likewise.
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

}  // namespace edgewise::measure
