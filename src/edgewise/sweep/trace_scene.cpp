// SPDX-License-Identifier: MIT
#include "edgewise/sweep/trace_scene.hpp"

#include <algorithm>
#include <limits>

#include "edgewise/measure/cache/cold_caches.hpp"
#include "edgewise/measure/cache/heat_map.hpp"
#include "edgewise/measure/cache/trace_fan_out.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/sweep/touched_tables.hpp"
#include "edgewise/bench/trace/trace_names.hpp"

namespace edgewise {

namespace {

std::vector<CacheMachine> known_machines(std::span<const MachineChoice> choices) {
    std::vector<CacheMachine> machines;
    for (const MachineChoice& choice : choices) {
        if (choice.machine.value) machines.push_back(*choice.machine.value);
    }
    return machines;
}

/// The last of the machines but the host, under the policies that can be.
std::vector<CacheMachine> other_policies(std::span<const CacheMachine> machines) {
    const CacheMachine* varied = nullptr;
    for (const CacheMachine& machine : machines) {
        if (machine.name != "host") varied = &machine;
    }
    std::vector<CacheMachine> others;
    if (!varied) return others;
    const auto fits_a_tree = [](const LevelGeometry& level) { return level.ways <= most_tree_ways; };
    const auto& levels = varied->caches.levels;
    if (std::all_of(levels.begin(), levels.end(), fits_a_tree))
        others.push_back(with_policy(*varied, Replacement::tree_plru));
    others.push_back(with_policy(*varied, Replacement::random));
    return others;
}

/// The machines in the order of the choices, then those under other policies.
void book_machines(const SceneCaches& caches, const ColdCaches& cold, std::span<const CacheMachine> machines,
                   std::span<const MachineChoice> choices, SceneTrace& trace) {
    const std::vector<MachineMisses> steady = caches.steady();
    std::size_t next = 0;
    for (const MachineChoice& choice : choices) {
        ModelledMachine& machine = trace.machines.emplace_back();
        machine.name = choice.name;
        machine.reason = choice.machine.reason;
        if (!choice.machine.value) continue;
        machine.first = caches.first()[next];
        machine.steady = steady[next];
        machine.cold = cold.misses(next);
        ++next;
    }
    for (; next < machines.size(); ++next)
        trace.policies.push_back({machines[next].name, {}, caches.first()[next], steady[next], {}});
}

SceneHeat heat_of(const HeatMap& heat, const Runner& runner) {
    return {heat.accesses_by_field(),
            heat.accesses_by_step(),
            heat.queries(),
            heat.lines(),
            heat.lines_taking(0.5),
            heat.lines_taking(0.9),
            touched_tables(runner.memory_maps(), heat.touched())};
}

/// Both passes through all listeners.
PassSum trace_passes(const Runner& runner, const Workload& workload, std::size_t limit,
                     std::span<const CacheMachine> machines, std::span<const MachineChoice> choices,
                     SceneTrace& trace) {
    const std::vector<CacheMachine> known = known_machines(choices);
    SceneCaches caches(machines, trace.fields.size(), trace.steps.size(), !workload.frames.empty());
    ColdCaches cold(known);
    HeatMap heat(trace.fields.size(), trace.steps.size());
    TraceFanOut first({&caches, &heat}), second({&caches, &heat, &cold});
    static_cast<void>(runner.trace(workload, limit, first));
    caches.start_steady();
    const PassSum sum = runner.trace(workload, limit, second);
    trace.queries = caches.queries();
    trace.frames = caches.frames();
    trace.lines = caches.lines();
    trace.pages = caches.pages();
    book_machines(caches, cold, machines, choices, trace);
    trace.heat = heat_of(heat, runner);
    return sum;
}

void add(Fingerprint& print, const CacheGeometry& geometry) {
    print.add(std::uint64_t{geometry.line_bytes});
    for (const LevelGeometry& level : geometry.levels) {
        print.add(level.name).add(std::uint64_t{level.sets}).add(std::uint64_t{level.ways});
        print.add(static_cast<std::uint64_t>(level.inclusion));
        print.add(static_cast<std::uint64_t>(level.replacement));
    }
}

}  // namespace

double trace_identity(std::span<const MachineChoice> choices, std::size_t queries) {
    Fingerprint print;
    print.add(std::uint64_t{queries});
    for (const MachineChoice& choice : choices) {
        print.add(choice.name);
        if (!choice.machine.value) continue;
        const CacheMachine& machine = *choice.machine.value;
        print.add(machine.clock_mhz).add(machine.memory.latency_cycles);
        for (const LevelOrigin& origin : machine.origins) print.add(origin.latency_cycles);
        add(print, machine.caches);
        add(print, machine.tlbs);
    }
    // A figure is a double: as many bits as it holds exactly.
    return static_cast<double>(print.value() >> 12);
}

SceneTrace trace_scene(const Runner& runner, const Workload& workload, std::size_t queries,
                       std::span<const MachineChoice> choices) {
    SceneTrace trace;
    trace.identity = trace_identity(choices, queries);
    if (!runner.table_allocator().base()) {
        trace.reason = "addresses of this allocator are not the same in every run";
        trace.remedy = "allocator=arena";
        return trace;
    }
    trace.reason.clear();
    trace.remedy.clear();
    trace.fields = field_names();
    trace.steps = step_names();
    trace.tables = runner.memory().tables;
    std::vector<CacheMachine> machines = known_machines(choices);
    for (CacheMachine& other : other_policies(machines)) machines.push_back(std::move(other));
    const std::size_t limit = queries > 0 ? queries : std::numeric_limits<std::size_t>::max();
    const PassSum sum = trace_passes(runner, workload, limit, machines, choices, trace);
    trace.answered = sum.queries;
    trace.distances = sum.distances;
    return trace;
}

}  // namespace edgewise
