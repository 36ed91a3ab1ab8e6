// SPDX-License-Identifier: MIT
//
// Seeds of a campaign's generators: of a block from the campaign's seed, of a pair from its block's.
#pragma once

#include <cstdint>

#include "edgewise/geometry/split_mix.hpp"

namespace edgewise::studies::campaign {

/// Returns child `number` of a seed; children of neighbouring numbers are unrelated.
[[nodiscard]] constexpr std::uint64_t child_seed(std::uint64_t seed, std::uint64_t number) {
    std::uint64_t state = seed ^ (number * 0xd1342543de82ef95);
    const std::uint64_t first = split_mix(state);
    return first ^ split_mix(state);
}

}  // namespace edgewise::studies::campaign
