// SPDX-License-Identifier: MIT
//
// Machines to model, chosen by name: one that comes with Edgewise, `host`, the user's own JSON file, or sizes
// (l2=256K,l3=8M); and a machine under another replacement policy, to see whether that changes what is
// concluded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

// A machine to model from the sizes of its caches alone: "l2=256K,l3=8M". The rest is usual and marked as
// unverified: lines of 64 bytes; 8 ways, 16 from the third level on; a first level of 32 KiB where none is
// named; LRU, non-inclusive. Latencies are not known, so no time is computed of its misses.

/// Returns the bytes of "256K", "8M", "1G" (binary) or a plain number; nothing for any other text.
[[nodiscard]] std::optional<std::uint64_t> bytes_of_size(std::string_view text);

/// Returns true if a name is a level with its size: "l2=256K".
[[nodiscard]] bool is_level_size(std::string_view name);

/// Joins consecutive levels to one machine ("l2=256K", "l3=8M" -> "l2=256K,l3=8M"); a level that does not
/// lie deeper than the one before begins another machine. Other names stay unchanged.
[[nodiscard]] std::vector<std::string> joined_level_sizes(std::span<const std::string> names);

/// Returns a machine with a name like "l2_256K_l3_8M". Throws std::invalid_argument: what, what to do.
[[nodiscard]] CacheMachine machine_of_sizes(const std::string& text);

struct MachineChoice {
    std::string name;
    Expected<CacheMachine> machine;  ///< unknown: this host does not report its caches
};

/// Throws std::invalid_argument for an unknown name, listing the known ones, and std::runtime_error for a bad
/// file: file, field, what is wanted.
[[nodiscard]] std::vector<MachineChoice> choose_machines(std::span<const std::string> names);

/// Machines for figures that must be the same everywhere: throws std::invalid_argument for `host` too.
[[nodiscard]] std::vector<CacheMachine> described_machines(const std::vector<std::string>& names);

/// This machine as one to model: sizes, ways and line of the first kind of read_cores. The kernel reports no
/// latencies, inclusion or replacement of the levels: latencies are left out, and the model's defaults
/// (non-inclusive, LRU) are marked as unverified. `root` is "/" except in tests.
[[nodiscard]] Expected<CacheMachine> host_machine(const std::filesystem::path& root = "/");

/// The machine with every level of this policy, called "zen5/tree_plru".
[[nodiscard]] CacheMachine with_policy(CacheMachine machine, Replacement policy);

}  // namespace edgewise::measure
