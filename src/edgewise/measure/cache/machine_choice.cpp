// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/machine_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/input/file_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/measure/cache/machine_of_sizes.hpp"
#include "edgewise/measure/machine/machine.hpp"

namespace edgewise::measure {

namespace {

constexpr const char* source =
    "/sys/devices/system/cpu/cpu0/cache (in a virtual machine: what the host lets it see)";

/// Empty, or what is wrong with the kernel's word for a model.
std::string add_level(const Cache& cache, CacheMachine& machine) {
    const auto known = [](const Expected<std::int64_t>& fact) { return fact.value && *fact.value > 0; };
    if (!known(cache.level) || !known(cache.bytes) || !known(cache.ways) || !known(cache.line_bytes))
        return "sysfs does not tell level, size, ways and line of every cache; write what you know of it, as "
               "in --machines l1=32K,l2=256K";
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

Expected<CacheMachine> host_machine(const std::filesystem::path& root) {
    const Expected<std::vector<Cache>> caches = read_caches(root);
    if (!caches.value) return caches.refusal();
    CacheMachine machine;
    machine.name = "host";
    machine.what = "this machine, as the kernel tells it";
    machine.memory.source = source;
    for (const Cache& cache : *caches.value) {
        if (cache.type.value.value_or("") == "Instruction") continue;
        if (const std::string problem = add_level(cache, machine); !problem.empty()) return Refusal{problem};
    }
    if (machine.caches.levels.empty()) return Refusal{"sysfs tells of no data cache"};
    return {machine};
}

std::vector<MachineChoice> choose_machines(std::span<const std::string> names) {
    std::vector<MachineChoice> choices;
    for (const std::string& name : joined_level_sizes(names)) {
        MachineChoice choice{name, machine_of(name)};
        if (choice.machine.value) choice.name = choice.machine.value->name;
        const bool twice = std::any_of(choices.begin(), choices.end(),
                                       [&](const MachineChoice& other) { return other.name == choice.name; });
        if (twice) throw std::invalid_argument(fmt::format("two machines are called '{}'", choice.name));
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
