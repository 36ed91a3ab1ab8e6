// SPDX-License-Identifier: MIT
#include "edgewise/measure/lock/layout_facts.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "edgewise/measure/cache/scene_caches.hpp"

namespace edgewise::measure {

namespace {

double mean(std::uint64_t sum, std::uint64_t queries) {
    return static_cast<double>(sum) / static_cast<double>(queries);
}

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

void add_misses(const LayoutFacts& facts, const LayoutFacts::Machine& machine, std::string& text) {
    each_population(facts.lines, [&](std::string_view suffix, const auto& of) {
        const std::uint64_t queries = of(facts.lines).queries;
        for (const LevelMisses& level : of(machine.steady).caches) {
            fmt::format_to(std::back_inserter(text), "{} {} misses per query{}: {:.4f}", machine.name,
                           level.level, suffix, mean(level.misses.all(), queries));
            for (std::size_t i = 0; i < facts.fields.size(); ++i) {
                if (level.by_field[i] > 0)
                    fmt::format_to(std::back_inserter(text), "  {} {:.4f}", facts.fields[i],
                                   mean(level.by_field[i], queries));
            }
            text += '\n';
        }
    });
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
    const auto out = std::back_inserter(text);
    for (const ComponentBytes& part : facts.bytes)
        fmt::format_to(out, "bytes.{}: {}\n", part.component, part.bytes);
    fmt::format_to(out, "distinct lines of 64 bytes: {}\n", facts.distinct_lines);
    each_population(facts.lines, [&](std::string_view suffix, const auto& of) {
        const LinesTouched& sums = of(facts.lines);
        fmt::format_to(out, "queries{0}: {1}\nlines per query{0}: {2:.4f}\nknee{0}: {3} bytes\n", suffix,
                       sums.queries, mean(sums.lines, sums.queries), of(facts.knee_bytes).value_or(0));
    });
    for (const LayoutFacts::Machine& machine : facts.machines) add_misses(facts, machine, text);
    return text;
}

}  // namespace edgewise::measure
