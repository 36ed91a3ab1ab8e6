// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/machine_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "edgewise/measure/machine/host_machine.hpp"

namespace edgewise::measure {

namespace {

Expected<CacheMachine> from_file(const std::string& file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(file + ": cannot be read");
    std::ostringstream text;
    text << stream.rdbuf();
    CacheMachine machine = parse_cache_machine(text.str(), file);
    machine.name = std::filesystem::path(file).stem().string();
    if (machine.name.find_first_of("./ ") != std::string::npos)
        throw std::runtime_error(file + ": its name becomes part of figures' names: no dots, no blanks");
    return {machine};
}

Expected<CacheMachine> machine_of(const std::string& name) {
    if (name == "host") return host_machine();
    if (name.ends_with(".json")) return from_file(name);
    std::string known = "host";
    for (const CacheMachine& machine : cache_machines()) {
        if (machine.name == name) return {machine};
        known += ", " + machine.name;
    }
    throw std::invalid_argument(
        fmt::format("unknown machine '{}'; known: {}, or a file NAME.json", name, known));
}

}  // namespace

std::vector<MachineChoice> choose_machines(std::span<const std::string> names) {
    std::vector<MachineChoice> choices;
    for (const std::string& name : names) {
        MachineChoice choice{name, machine_of(name)};
        if (choice.machine.value) choice.name = choice.machine.value->name;
        const bool twice = std::any_of(choices.begin(), choices.end(),
                                       [&](const MachineChoice& other) { return other.name == choice.name; });
        if (twice) throw std::invalid_argument(fmt::format("two machines are called '{}'", choice.name));
        choices.push_back(std::move(choice));
    }
    return choices;
}

CacheMachine with_policy(CacheMachine machine, Replacement policy) {
    constexpr const char* names[] = {"lru", "tree_plru", "random"};
    machine.name += fmt::format("/{}", names[static_cast<std::size_t>(policy)]);
    for (LevelGeometry& level : machine.caches.levels) level.replacement = policy;
    return machine;
}

}  // namespace edgewise::measure
