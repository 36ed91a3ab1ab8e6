// SPDX-License-Identifier: MIT
#include "edgewise/bench/trace/cache_order.hpp"

#include "edgewise/bench/cell.hpp"

namespace edgewise::bench {

namespace {

void add(Fingerprint& print, const measure::CacheGeometry& geometry) {
    print.add(std::uint64_t{geometry.line_bytes});
    for (const measure::LevelGeometry& level : geometry.levels) {
        print.add(level.name).add(std::uint64_t{level.sets}).add(std::uint64_t{level.ways});
        print.add(static_cast<std::uint64_t>(level.inclusion));
        print.add(static_cast<std::uint64_t>(level.replacement));
    }
}

}  // namespace

double CacheOrder::identity() const {
    Fingerprint print;
    print.add(std::uint64_t{queries});
    for (const measure::MachineChoice& choice : machines) {
        print.add(choice.name);
        if (!choice.machine.value) continue;
        const measure::CacheMachine& machine = *choice.machine.value;
        print.add(machine.clock_mhz).add(machine.memory.latency_cycles);
        for (const measure::LevelOrigin& origin : machine.origins) print.add(origin.latency_cycles);
        add(print, machine.caches);
        add(print, machine.tlbs);
    }
    // A figure is a double: as many bits as it holds exactly.
    return static_cast<double>(print.value() >> 12);
}

}  // namespace edgewise::bench
