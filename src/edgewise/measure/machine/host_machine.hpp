// SPDX-License-Identifier: MIT
//
// This machine as one to model: sizes, ways and line from sysfs (caches.hpp). How long its levels take, which
// contain which and what they evict the kernel does not tell: latencies are left out, and the model's
// defaults (non-inclusive, LRU) are marked as unverified.
#pragma once

#include <filesystem>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/machine/read_text.hpp"

namespace edgewise::measure {

/// `root` is "/" except in tests.
[[nodiscard]] Expected<CacheMachine> host_machine(const std::filesystem::path& root = "/");

}  // namespace edgewise::measure
