// SPDX-License-Identifier: MIT
//
// SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014): three lines,
// full period, the same bits everywhere.
#pragma once

#include <cstdint>

namespace edgewise {

/// Returns the next 64 random bits and advances `state`, which starts as the seed.
[[nodiscard]] constexpr std::uint64_t split_mix(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

}  // namespace edgewise
