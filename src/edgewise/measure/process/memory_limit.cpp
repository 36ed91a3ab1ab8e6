// SPDX-License-Identifier: MIT
//
// Files as in the Linux kernel's Documentation/admin-guide/cgroup-v1/memory.rst and cgroup-v2.rst.
#include "edgewise/measure/process/memory_limit.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

namespace edgewise::measure {

/// What a version of the kernel's interface calls things.
struct MemoryLimit::Hierarchy {
    const char *mount, *sign, *controller;  ///< the sign is a file that is there where it is mounted
    const char *limit, *unlimited;          ///< a file of a group, and its value without a limit
};

namespace {

namespace fs = std::filesystem;

constexpr const char* group_start = "edgewise-";  ///< then the number of the process

/// Empty, or what went wrong; the kernel answers at the flush.
std::string write_to(const fs::path& file, const std::string& text) {
    errno = 0;
    std::ofstream stream(file);
    if (stream << text << std::flush) return {};
    return fmt::format("{}: cannot write {}: {}", file.string(), text, std::strerror(errno));
}

/// Removes what processes left that were killed before they could: groups named after one that is no more.
/// The kernel keeps a group that still has a process.
void remove_orphans(const fs::path& parent) {
    const std::string start = group_start;
    std::error_code error;
    for (fs::directory_iterator at(parent, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (!name.starts_with(start)) continue;
        int process = 0;
        const char* const last = name.data() + name.size();
        const auto [stop, bad] = std::from_chars(name.data() + start.size(), last, process);
        const bool is_number = bad == std::errc{} && stop == last && process > 0;
        if (is_number && kill(process, 0) != 0 && errno == ESRCH) rmdir(at->path().c_str());
    }
}

/// A new folder in the first of the parents that takes one.
fs::path new_folder(const std::vector<fs::path>& parents, const std::string& wanted_file, std::string& why) {
    for (const fs::path& parent : parents) {
        remove_orphans(parent);
        const fs::path folder = parent / fmt::format("{}{}", group_start, getpid());
        std::error_code error;
        if (!fs::create_directory(folder, error)) {
            why = fmt::format("{}: {}", folder.string(), error ? error.message() : "is there already");
            continue;
        }
        if (fs::exists(folder / wanted_file)) return folder;
        why = fmt::format("{}: the memory controller is not handed down to it", folder.string());
        fs::remove(folder, error);
    }
    return {};
}

/// From the process's own group up to the mount itself.
std::vector<fs::path> upwards(const fs::path& mount, const std::string& group) {
    std::vector<fs::path> parents;
    for (fs::path at = fs::path(group).relative_path(); !at.empty(); at = at.parent_path())
        parents.push_back(mount / at);
    parents.push_back(mount);
    return parents;
}

}  // namespace

/// Lines are NUMBER:CONTROLLERS:PATH, controllers with commas between; version 2 has none.
std::string control_group_in(const std::string& text, const std::string& controller) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const auto first = line.find(':'), second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const auto controllers = fmt::format(",{},", line.substr(first + 1, second - first - 1));
        if (controllers.find(fmt::format(",{},", controller)) == std::string::npos) continue;
        if (controller.empty() == (controllers == ",,")) return line.substr(second + 1);
    }
    return {};
}

Expected<std::unique_ptr<MemoryLimit>> MemoryLimit::make(const fs::path& root) {
    static constexpr Hierarchy versions[] = {
        {"sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory", "memory.limit_in_bytes", "-1"},
        {"sys/fs/cgroup", "cgroup.controllers", "", "memory.max", "max"},
    };
    std::string why = "no memory control groups are mounted";
    const std::string groups = read_text(root / "proc/self/cgroup").value.value_or("");
    for (const Hierarchy& version : versions) {
        const fs::path mount = root / version.mount;
        if (!fs::exists(mount / version.sign)) continue;
        const auto parents = upwards(mount, control_group_in(groups, version.controller));
        const fs::path folder = new_folder(parents, version.limit, why);
        if (!folder.empty()) return {std::unique_ptr<MemoryLimit>(new MemoryLimit(folder, version))};
    }
    return Refusal{why};
}

MemoryLimit::~MemoryLimit() {
    // The kernel may need a moment to see that the last process is gone.
    for (int i = 0; i < 100 && rmdir(folder_.c_str()) != 0 && errno == EBUSY; ++i) usleep(10'000);
}

std::string MemoryLimit::set_bytes(std::uint64_t bytes) const {
    return write_to(folder_ / version_.limit, bytes > 0 ? std::to_string(bytes) : version_.unlimited);
}

std::string MemoryLimit::take_in(pid_t process) const {
    return write_to(folder_ / "cgroup.procs", std::to_string(process));
}

}  // namespace edgewise::measure
