// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/machine_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "edgewise/input/count.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/measure/machine/machine.hpp"

namespace edgewise::measure {
namespace {

constexpr std::uint64_t line_bytes = 64, least_first_level = 1024, most_level = std::uint64_t{1} << 40;
constexpr std::uint64_t usual_first_level = 32 * 1024;

constexpr const char* usual =
    "a size that was asked for; ways, replacement and inclusion are what is usual, latencies are not known";

/// 2 of "l2=256K".
int level_of(std::string_view name) { return name[1] - '0'; }

/// Sizes need not be powers of two, but whole sets: of the usual ways, or the next fewer that divide them.
void add_level(int level, std::uint64_t bytes, CacheMachine& machine) {
    const std::uint64_t lines = bytes / line_bytes;
    std::uint32_t ways = level < 3 ? 8 : 16;
    while (lines % ways != 0) --ways;
    machine.caches.levels.push_back(
        {fmt::format("L{}{}", level, level == 1 ? "D" : ""), static_cast<std::uint32_t>(lines / ways), ways});
    machine.origins.push_back({0, usual, {"ways", "inclusion", "replacement"}});
}

constexpr const char* source =
    "/sys/devices/system/cpu/cpu*/cache (in a virtual machine: what the host lets it see)";

/// Adds a level to the machine. Returns why a model cannot use the kernel's numbers; empty if it can.
std::string add_level(const Cache& cache, CacheMachine& machine) {
    const auto known = [](const Expected<std::int64_t>& fact) { return fact.value && *fact.value > 0; };
    if (!known(cache.level) || !known(cache.bytes) || !known(cache.ways) || !known(cache.line_bytes))
        return "sysfs does not give level, size, ways and line of every cache; write the sizes that you "
               "know, as in --machines l1=32K,l2=256K";
    const std::int64_t line = *cache.line_bytes.value, ways = *cache.ways.value;
    if (*cache.bytes.value % (line * ways) != 0) return "a cache's size is no multiple of its ways' size";
    if (machine.caches.levels.empty()) machine.caches.line_bytes = static_cast<std::uint32_t>(line);
    if (line != machine.caches.line_bytes) return "caches with lines of several sizes are not modelled";
    const auto sets = static_cast<std::uint32_t>(*cache.bytes.value / (line * ways));
    std::string name = fmt::format("L{}{}", *cache.level.value, *cache.level.value == 1 ? "D" : "");
    // Intel's Lion Cove has two data caches before its L2, and the kernel calls both level 1.
    const auto same = std::ranges::count_if(
        machine.caches.levels, [&](const LevelGeometry& level) { return level.name.starts_with(name); });
    if (same > 0) name += fmt::format("_{}", same + 1);
    machine.caches.levels.push_back({name, sets, static_cast<std::uint32_t>(ways)});
    machine.origins.push_back({0, source, {"inclusion", "replacement"}});
    return {};
}

Expected<CacheMachine> from_file(const std::string& file) {
    const auto text = input::read_file_text(file);
    if (!text) throw std::runtime_error(text.error);
    CacheMachine machine = parse_cache_machine(*text, file);
    machine.name = std::filesystem::path(file).stem().string();
    if (machine.name.find_first_of("./ ") != std::string::npos)
        throw std::runtime_error(file + ": its name becomes part of figures' names: no dots, no blanks");
    return {machine};
}

Expected<CacheMachine> machine_of(const std::string& name) {
    if (name == "host") return host_machine();
    if (name.ends_with(".json")) return from_file(name);
    if (is_level_size(name)) return {machine_of_sizes(name)};
    std::vector<std::string> known = {"host"};
    for (const CacheMachine& machine : cache_machines()) {
        if (machine.name == name) return {machine};
        known.push_back(machine.name);
    }
    throw std::invalid_argument(unknown_name("machine", name, known) +
                                ", a file NAME.json, or sizes as in l2=256K,l3=8M");
}

}  // namespace

std::optional<std::uint64_t> bytes_of_size(std::string_view text) {
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    const auto value = input::parse_count(text.substr(0, digits), {1, most_level});
    if (!value) return std::nullopt;
    std::string_view unit = text.substr(digits);
    if (unit.size() == 3 && unit.ends_with("iB")) unit.remove_suffix(2);
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
                fmt::format("machine '{}': write levels in ascending order, as in l2=256K,l3=8M", text));
        if (last == 0 && level_of(level) > 1) add_level(1, std::min(usual_first_level, *bytes), machine);
        last = level_of(level);
        add_level(last, *bytes, machine);
        machine.name += fmt::format("{}l{}_{}", machine.name.empty() ? "" : "_", last, level.substr(3));
    }
    return machine;
}

Expected<CacheMachine> host_machine(const std::filesystem::path& root) {
    const Expected<std::vector<CoreKind>> cores = read_cores(root);
    if (!cores.value) return cores.refusal();
    CacheMachine machine;
    machine.name = "host";
    machine.what = "this machine, as the kernel reports it";
    if (cores.value->size() > 1)
        machine.what += ": processors " + processor_list(cores.value->front().processors);
    machine.memory.source = source;
    for (const Cache& cache : cores.value->front().caches) {
        if (cache.type.value.value_or("") == "Instruction") continue;
        if (const std::string problem = add_level(cache, machine); !problem.empty()) return Refusal{problem};
    }
    if (machine.caches.levels.empty()) return Refusal{"sysfs lists no data cache"};
    return {machine};
}

std::vector<MachineChoice> choose_machines(std::span<const std::string> names) {
    std::vector<MachineChoice> choices;
    for (const std::string& name : joined_level_sizes(names)) {
        MachineChoice choice{name, machine_of(name)};
        if (choice.machine.value) choice.name = choice.machine.value->name;
        if (std::ranges::find(choices, choice.name, &MachineChoice::name) != choices.end())
            throw std::invalid_argument(fmt::format("two machines are called '{}'", choice.name));
        choices.push_back(std::move(choice));
    }
    return choices;
}

std::vector<CacheMachine> described_machines(const std::vector<std::string>& names) {
    std::vector<CacheMachine> machines;
    for (MachineChoice& choice : choose_machines(names)) {
        if (choice.name == "host")
            throw std::invalid_argument(
                "host is another machine elsewhere, and figures here must not depend on that: name others");
        machines.push_back(*std::move(choice.machine.value));
    }
    return machines;
}

CacheMachine with_policy(CacheMachine machine, Replacement policy) {
    constexpr const char* names[] = {"lru", "tree_plru", "random"};
    machine.name += fmt::format("/{}", names[static_cast<std::size_t>(policy)]);
    for (LevelGeometry& level : machine.caches.levels) level.replacement = policy;
    return machine;
}

}  // namespace edgewise::measure
