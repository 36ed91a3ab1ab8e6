// SPDX-License-Identifier: MIT
//
// A memory control group of the kernel, version 1 or 2: it limits the memory of the processes in it, so that
// pages of files are evicted and read again. Made for one measurement and removed after it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "edgewise/measure/machine/machine.hpp"

namespace edgewise::measure {

/// A process's group below a hierarchy's mount, from the text of its /proc/self/cgroup: of the named
/// controller, or with an empty name of version 2. Empty when there is none.
[[nodiscard]] std::string control_group_in(const std::string& text, const std::string& controller);

class MemoryLimit {
  public:
    /// Makes a group. Refused if this process may not make one. `root` is "/" except in tests.
    [[nodiscard]] static Expected<std::unique_ptr<MemoryLimit>> make(const std::filesystem::path& root = "/");
    /// Removes the group; its processes must have ended.
    ~MemoryLimit();
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;

    /// Sets the limit; 0 bytes: none. Returns what the kernel refused, or an empty text.
    [[nodiscard]] std::string set_bytes(std::uint64_t bytes) const;
    [[nodiscard]] std::string take_in(pid_t process) const;

  private:
    struct Hierarchy;
    MemoryLimit(std::filesystem::path folder, const Hierarchy& version)
        : folder_(std::move(folder)), version_(version) {}

    std::filesystem::path folder_;
    const Hierarchy& version_;
};

}  // namespace edgewise::measure
