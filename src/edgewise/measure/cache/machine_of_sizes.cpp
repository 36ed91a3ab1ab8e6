// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/machine_of_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "edgewise/input/count.hpp"

namespace edgewise::measure {

namespace {

constexpr std::uint64_t line_bytes = 64, least_first_level = 1024, most_level = std::uint64_t{1} << 40;
constexpr std::uint64_t usual_first_level = 32 * 1024;

constexpr const char* usual =
    "a size that was asked for; ways, replacement and inclusion are what is usual, latencies are not known";

std::uint32_t usual_ways(int level) { return level < 3 ? 8 : 16; }

/// 2 of "l2=256K".
int level_of(std::string_view name) { return name[1] - '0'; }

/// Sizes need not be powers of two, but whole sets: of the usual ways, or the next fewer that divide them.
LevelGeometry level_geometry(int level, std::uint64_t bytes) {
    const std::uint64_t lines = bytes / line_bytes;
    std::uint32_t ways = usual_ways(level);
    while (lines % ways != 0) --ways;
    return {fmt::format("L{}{}", level, level == 1 ? "D" : ""), static_cast<std::uint32_t>(lines / ways),
            ways};
}

void add_level(int level, std::uint64_t bytes, CacheMachine& machine) {
    machine.caches.levels.push_back(level_geometry(level, bytes));
    machine.origins.push_back({0, usual, {"ways", "inclusion", "replacement"}});
}

}  // namespace

std::optional<std::uint64_t> bytes_of_size(std::string_view text) {
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    const auto value = input::parse_count(text.substr(0, digits), {1, most_level});
    if (!value) return std::nullopt;
    std::string_view unit = text.substr(digits);
    if (unit.ends_with("iB")) unit.remove_suffix(2);
    constexpr std::string_view units = "KMG";
    int shift = 0;
    if (unit.size() == 1 && units.find(static_cast<char>(unit[0] & ~0x20)) != units.npos)
        shift = 10 * static_cast<int>(units.find(static_cast<char>(unit[0] & ~0x20)) + 1);
    else if (!unit.empty())
        return std::nullopt;
    if (*value > (most_level >> shift)) return std::nullopt;
    return *value << shift;
}

bool is_level_size(std::string_view name) {
    return name.size() > 3 && (name[0] == 'l' || name[0] == 'L') && name[1] >= '1' && name[1] <= '9' &&
           name[2] == '=';
}

std::vector<std::string> joined_level_sizes(std::span<const std::string> names) {
    std::vector<std::string> joined;
    int last = 0;  // level of the machine that the last name is of; 0: it is none of sizes
    for (const std::string& name : names) {
        const int level = is_level_size(name) ? level_of(name) : 0;
        if (level > last && last > 0) {
            joined.back() += "," + name;
        } else {
            joined.push_back(name);
        }
        // What was written with its commas in one word: the deepest level counts.
        const std::size_t comma = name.rfind(',');
        const std::string_view deepest = comma == name.npos ? name : std::string_view(name).substr(comma + 1);
        last = is_level_size(deepest) ? level_of(deepest) : 0;
    }
    return joined;
}

CacheMachine machine_of_sizes(const std::string& text) {
    CacheMachine machine;
    machine.what = "a machine with " + text;
    machine.caches.line_bytes = line_bytes;
    machine.memory.source = usual;
    std::istringstream levels(text);
    int last = 0;
    for (std::string level; std::getline(levels, level, ',');) {
        const auto bytes = is_level_size(level) ? bytes_of_size(level.substr(3)) : std::nullopt;
        if (!bytes || *bytes < least_first_level || *bytes % line_bytes != 0)
            throw std::invalid_argument(fmt::format(
                "machine '{}': '{}' is no level; write a level and its size, whole lines of {} bytes from "
                "{} on, as in l2=256K,l3=8M",
                text, level, line_bytes, least_first_level));
        if (level_of(level) <= last)
            throw std::invalid_argument(
                fmt::format("machine '{}': levels stand in their order, as in l2=256K,l3=8M", text));
        if (last == 0 && level_of(level) > 1) add_level(1, std::min(usual_first_level, *bytes), machine);
        last = level_of(level);
        add_level(last, *bytes, machine);
        machine.name += fmt::format("{}l{}_{}", machine.name.empty() ? "" : "_", last, level.substr(3));
    }
    return machine;
}

}  // namespace edgewise::measure
