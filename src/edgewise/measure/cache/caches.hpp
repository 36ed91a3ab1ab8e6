// SPDX-License-Identifier: MIT
//
// The caches of the first processor as the kernel tells them in sysfs (Documentation/ABI/testing/
// sysfs-devices-system-cpu). In a virtual machine that is what the hypervisor chose to tell.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "edgewise/measure/machine/read_text.hpp"

namespace edgewise::measure {

struct Cache {
    Expected<std::int64_t> level, bytes, ways, line_bytes, sets;
    Expected<std::string> type;         ///< Data, Instruction or Unified
    Expected<std::string> shared_cpus;  ///< logical processors that share it, e.g. "0-7"
};

/// In the order of sysfs (level 1 first). `root` is "/" except in tests.
[[nodiscard]] Expected<std::vector<Cache>> read_caches(const std::filesystem::path& root);

}  // namespace edgewise::measure
