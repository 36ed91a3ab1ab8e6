// SPDX-License-Identifier: MIT
//
// Machines to model, chosen by name: one that comes with Edgewise, `host`, the user's own JSON file, or sizes
// (l2=256K,l3=8M); and a machine under another replacement policy, to see whether that changes what is
// concluded.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

struct MachineChoice {
    std::string name;
    Expected<CacheMachine> machine;  ///< unknown: this host does not tell its caches
};

/// Throws std::invalid_argument for an unknown name, listing the known ones, and std::runtime_error for a bad
/// file: file, field, what is wanted.
[[nodiscard]] std::vector<MachineChoice> choose_machines(std::span<const std::string> names);

/// The same where figures must be the same on every machine: throws std::invalid_argument for `host` too.
[[nodiscard]] std::vector<CacheMachine> described_machines(const std::vector<std::string>& names);

/// This machine as one to model: sizes, ways and line from sysfs. How long its levels take, which contain
/// which and what they evict the kernel does not tell: latencies are left out, and the model's defaults
/// (non-inclusive, LRU) are marked as unverified. `root` is "/" except in tests.
[[nodiscard]] Expected<CacheMachine> host_machine(const std::filesystem::path& root = "/");

/// The machine with every level of this policy, called "zen5/tree_plru".
[[nodiscard]] CacheMachine with_policy(CacheMachine machine, Replacement policy);

}  // namespace edgewise::measure
