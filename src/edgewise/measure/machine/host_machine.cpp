// SPDX-License-Identifier: MIT
#include "edgewise/measure/machine/host_machine.hpp"

#include <fmt/format.h>

#include "edgewise/measure/cache/caches.hpp"

namespace edgewise::measure {

namespace {

constexpr const char* source =
    "/sys/devices/system/cpu/cpu0/cache (in a virtual machine: what the host lets it see)";

/// Empty, or what is wrong with the kernel's word for a model.
std::string add_level(const Cache& cache, CacheMachine& machine) {
    const auto known = [](const Expected<std::int64_t>& fact) { return fact.value && *fact.value > 0; };
    if (!known(cache.level) || !known(cache.bytes) || !known(cache.ways) || !known(cache.line_bytes))
        return "sysfs does not tell level, size, ways and line of every cache";
    const std::int64_t line = *cache.line_bytes.value, ways = *cache.ways.value;
    if (*cache.bytes.value % (line * ways) != 0) return "a cache's size is no multiple of its ways' size";
    if (machine.caches.levels.empty()) machine.caches.line_bytes = static_cast<std::uint32_t>(line);
    if (line != machine.caches.line_bytes) return "caches with lines of several sizes are not modelled";
    const auto sets = static_cast<std::uint32_t>(*cache.bytes.value / (line * ways));
    const std::string name = fmt::format("L{}{}", *cache.level.value, *cache.level.value == 1 ? "D" : "");
    machine.caches.levels.push_back({name, sets, static_cast<std::uint32_t>(ways)});
    machine.origins.push_back({0, source, {"inclusion", "replacement"}});
    return {};
}

}  // namespace

Expected<CacheMachine> host_machine(const std::filesystem::path& root) {
    const Expected<std::vector<Cache>> caches = read_caches(root);
    if (!caches.value) return Expected<CacheMachine>::none(caches.reason);
    CacheMachine machine;
    machine.name = "host";
    machine.what = "this machine, as the kernel tells it";
    machine.memory.source = source;
    for (const Cache& cache : *caches.value) {
        if (cache.type.value.value_or("") == "Instruction") continue;
        if (const std::string problem = add_level(cache, machine); !problem.empty())
            return Expected<CacheMachine>::none(problem);
    }
    if (machine.caches.levels.empty()) return Expected<CacheMachine>::none("sysfs tells of no data cache");
    return {machine};
}

}  // namespace edgewise::measure
