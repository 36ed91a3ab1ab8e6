// SPDX-License-Identifier: MIT
#include "edgewise/measure/lock/layout_facts.hpp"

#include <fmt/format.h>

#include <utility>

#include "edgewise/measure/cache/scene_caches.hpp"
#include "edgewise/measure/lock/lock_program.hpp"

namespace edgewise::measure {

namespace {

ByStart<std::optional<std::uint64_t>> knees(const ReuseOf& lines, const ByStart<LinesTouched>& queries) {
    const auto of = [&](const MissCurve& curve, std::uint64_t touched,
                        const LinesTouched& counted) -> std::optional<std::uint64_t> {
        if (counted.queries == 0) return std::nullopt;
        return knee(curve, touched) * lines.unit_bytes;
    };
    return {of(lines.steady.all, lines.with_scene.all, queries.all),
            of(lines.steady.cold, lines.with_scene.cold, queries.cold),
            of(lines.steady.warm, lines.with_scene.warm, queries.warm)};
}

}  // namespace

LayoutFacts measure_layout(const std::function<void(TraceListener&)>& pass,
                           std::span<const CacheMachine> machines, std::vector<std::string> fields,
                           std::size_t steps) {
    LineCounter lines;
    SceneCaches caches(machines, fields.size(), steps);
    ColdCaches cold(machines);
    TraceFanOut first({&caches, &lines, &cold});
    pass(first);
    caches.start_steady();
    pass(caches);
    LayoutFacts facts;
    facts.lines = lines.sums();
    facts.fields = std::move(fields);
    const std::vector<ByStart<MachineMisses>> steady = caches.steady();
    for (std::size_t i = 0; i < machines.size(); ++i) {
        const auto& emptied = cold.misses(i);
        facts.machines.push_back(
            {machines[i].name, steady[i], {emptied.all[0], emptied.cold[0], emptied.warm[0]}});
    }
    const ReuseOf reuse = caches.lines();
    facts.distinct_lines = reuse.distinct;
    facts.knee_bytes = knees(reuse, facts.lines);
    return facts;
}

Expected<LayoutFacts> measure_layout(const TouchTrace& trace, std::span<const CacheMachine> machines) {
    if (!trace.problem().empty())
        return Expected<LayoutFacts>::none(trace.problem(),
                                           "add every array when it is built, name every field");
    LayoutFacts facts =
        measure_layout([&](TraceListener& listener) { trace.replay(listener); }, machines, trace.fields());
    if (facts.lines.all.queries == 0)
        return Expected<LayoutFacts>::none("the trace has no queries", "start_query() before each");
    facts.bytes = trace.structure().bytes();
    return {std::move(facts)};
}

std::string to_text(const LayoutFacts& facts) {
    std::string text;
    for (const RecordRow& row : lock_of(facts).rows) text += fmt::format("{}: {}\n", row.figure, row.value);
    each_population(facts.lines, [&](std::string_view suffix, const auto& of) {
        const auto queries = static_cast<double>(of(facts.lines).queries);
        for (const LayoutFacts::Machine& machine : facts.machines)
            for (const LevelMisses& level : of(machine.steady).caches)
                for (std::size_t i = 0; i < facts.fields.size(); ++i)
                    if (level.by_field[i] > 0)
                        text += fmt::format("misses_per_query.{}.{}{} of {}: {}\n", machine.name, level.level,
                                            suffix, facts.fields[i],
                                            static_cast<double>(level.by_field[i]) / queries);
    });
    return text;
}

}  // namespace edgewise::measure
