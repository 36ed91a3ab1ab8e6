// SPDX-License-Identifier: MIT
#include "edgewise/measure/lock/lock_program.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string_view>

namespace edgewise::measure {

int report_differences(const std::vector<LockDifference>& found, const std::string& file) {
    for (const LockDifference& difference : found) fmt::print("{}\n", to_text(difference));
    if (found.empty()) fmt::print("{} holds\n", file);
    return found.empty() ? 0 : 1;
}

int lock_program(int argc, const char* const* argv, const Expected<LayoutFacts>& facts,
                 std::vector<std::pair<std::string, std::string>> of) {
    const bool checks = argc == 3 && std::string_view(argv[1]) == "--check";
    if (argc != 1 && !checks) {
        fmt::print(stderr, "usage: {0} > FILE, or {0} --check FILE\n", argv[0]);
        return 2;
    }
    if (!facts.value) {
        fmt::print(stderr, "{}: {}; {}\n", argv[0], facts.reason, facts.remedy);
        return 2;
    }
    const LayoutLock lock = lock_of(*facts.value, std::move(of));
    if (!checks) {
        fmt::print("{}", to_json(lock));
        return 0;
    }
    try {
        return report_differences(differences(read_lock(argv[2]), lock), argv[2]);
    } catch (const std::exception& problem) {
        fmt::print(stderr, "{}: {}\n", argv[0], problem.what());
        return 2;
    }
}

}  // namespace edgewise::measure
