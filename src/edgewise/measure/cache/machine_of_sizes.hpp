// SPDX-License-Identifier: MIT
//
// A machine to model from the sizes of its caches alone: "l2=256K,l3=8M". The rest is usual and marked as
// unverified: lines of 64 bytes; 8 ways, 16 from the third level on; a first level of 32 KiB where none is
// named; LRU, non-inclusive. Latencies are not known, so no time is computed of its misses.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"

namespace edgewise::measure {

/// "256K", "8M", "1G" (binary), or bytes; nothing for anything else, and for nothing.
[[nodiscard]] std::optional<std::uint64_t> bytes_of_size(std::string_view text);

/// Whether a name is a level with its size: "l2=256K".
[[nodiscard]] bool is_level_size(std::string_view name);

/// Levels that stand in a row as one machine ("l2=256K", "l3=8M" -> "l2=256K,l3=8M"); a level that does not
/// lie deeper than the one before begins another. Other names as they are.
[[nodiscard]] std::vector<std::string> joined_level_sizes(std::span<const std::string> names);

/// Called "l2_256K_l3_8M". Throws std::invalid_argument: what, what to do.
[[nodiscard]] CacheMachine machine_of_sizes(const std::string& text);

}  // namespace edgewise::measure
