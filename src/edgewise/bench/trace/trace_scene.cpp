// SPDX-License-Identifier: MIT
#include "edgewise/bench/trace/trace_scene.hpp"

#include <algorithm>

#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/trace/touched_tables.hpp"
#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/measure/cache/heat_map.hpp"
#include "edgewise/measure/cache/scene_caches.hpp"

namespace edgewise::bench {

namespace {

std::vector<measure::CacheMachine> known_machines(std::span<const measure::MachineChoice> choices) {
    std::vector<measure::CacheMachine> machines;
    for (const measure::MachineChoice& choice : choices) {
        if (choice.machine.value) machines.push_back(*choice.machine.value);
    }
    return machines;
}

/// The last of the machines but the host, under the policies that can be, and with each prefetcher.
std::vector<measure::CacheMachine> other_policies(std::span<const measure::CacheMachine> machines) {
    const measure::CacheMachine* varied = nullptr;
    for (const measure::CacheMachine& machine : machines) {
        if (machine.name != "host") varied = &machine;
    }
    std::vector<measure::CacheMachine> others;
    if (!varied) return others;
    const auto fits_a_tree = [](const measure::LevelGeometry& level) {
        return level.ways <= measure::most_tree_ways;
    };
    const auto& levels = varied->caches.levels;
    if (std::all_of(levels.begin(), levels.end(), fits_a_tree))
        others.push_back(measure::with_policy(*varied, measure::Replacement::tree_plru));
    others.push_back(measure::with_policy(*varied, measure::Replacement::random));
    for (const char* prefetcher : {"/next_line", "/stream"}) {
        others.push_back(*varied);
        others.back().name += prefetcher;
    }
    return others;
}

/// The machines in the order of the choices, then those under other policies.
void book_machines(const measure::SceneCaches& caches, const measure::ColdCaches& cold,
                   std::span<const measure::CacheMachine> machines,
                   std::span<const measure::MachineChoice> choices, measure::SceneTrace& trace) {
    const std::vector<measure::ByStart<measure::MachineMisses>> steady = caches.steady();
    std::size_t next = 0;
    for (const measure::MachineChoice& choice : choices) {
        measure::ModelledMachine& machine = trace.machines.emplace_back();
        machine.name = choice.name;
        machine.reason = choice.machine.reason;
        if (!choice.machine.value) continue;
        machine.first = caches.first()[next];
        machine.steady = steady[next];
        machine.emptied = cold.misses(next);
        ++next;
    }
    for (; next < machines.size(); ++next)
        trace.policies.push_back({machines[next].name, {}, caches.first()[next], steady[next], {}});
}

measure::SceneHeat heat_of(const measure::HeatMap& heat, const Runner& runner) {
    return {heat.accesses_by_field(),
            heat.accesses_by_step(),
            heat.queries(),
            heat.lines_of_queries(),
            heat.lines(),
            heat.lines_taking(0.5),
            heat.lines_taking(0.9),
            touched_tables(runner.memory_maps(), heat.touched())};
}

/// Both passes through all listeners; what the second answered.
PassSum trace_passes(const Runner& runner, bool framed, const CacheOrder& order, measure::SceneTrace& trace) {
    const TraceExtent extent =
        order.queries > 0 ? TraceExtent(order.queries, order.steps) : TraceExtent::everything();
    const std::vector<measure::CacheMachine> known = known_machines(order.machines);
    std::vector<measure::CacheMachine> machines = known;
    for (measure::CacheMachine& other : other_policies(known)) machines.push_back(std::move(other));
    measure::SceneCaches caches(machines, trace.fields.size(), trace.steps.size(), framed);
    measure::ColdCaches cold(known);
    measure::HeatMap heat(trace.fields.size(), trace.steps.size());
    measure::TraceFanOut first({&caches, &heat}), second({&caches, &heat, &cold});
    static_cast<void>(runner.trace(extent, first));
    caches.start_steady();
    const PassSum sum = runner.trace(extent, second);
    trace.queries = caches.queries();
    trace.frames = caches.frames();
    trace.lines = caches.lines();
    trace.pages = caches.pages();
    book_machines(caches, cold, machines, order.machines, trace);
    trace.heat = heat_of(heat, runner);
    return sum;
}

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
    print.add(std::uint64_t{queries}).add(std::uint64_t{steps});
    for (const measure::MachineChoice& choice : machines) {
        print.add(choice.name);
        if (!choice.machine.value) continue;
        const measure::CacheMachine& machine = *choice.machine.value;
        print.add(machine.clock_mhz).add(machine.memory.latency_cycles);
        for (const measure::LevelOrigin& origin : machine.origins) print.add(origin.latency_cycles);
        add(print, machine.caches);
        add(print, machine.tlbs);
    }
    // A figure is a double: takes only the bits that it holds exactly.
    return static_cast<double>(print.value() >> 12);
}

measure::SceneTrace trace_scene(const Runner& runner, const scene::Workload& workload,
                                const CacheOrder& order) {
    measure::SceneTrace trace;
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
    const PassSum sum = trace_passes(runner, !workload.frames.empty(), order, trace);
    trace.answered = sum.queries;
    trace.distances = sum.distances;
    return trace;
}

const measure::SceneTrace& scene_trace(const ProbedCell& cell) {
    if (cell.trace) return *cell.trace;
    measure::SceneTrace trace;
    if (!cell.caches.machines.empty() && cell.verified) {
        trace = trace_scene(cell.runner, cell.workload, cell.caches);
    } else if (!cell.caches.machines.empty()) {
        trace.reason = "the cell was not verified";
        trace.remedy = "see the cell's own reason";
    }
    cell.trace = std::make_shared<const measure::SceneTrace>(std::move(trace));
    return *cell.trace;
}

}  // namespace edgewise::bench
