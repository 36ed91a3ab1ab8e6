// SPDX-License-Identifier: MIT
#include "edgewise/measure/lock/lock_program.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <utility>

#include "edgewise/measure/record/comparison.hpp"

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

namespace {

void add(FigureRecord& lock, std::string figure, double value) {
    lock.rows.push_back({.figure = std::move(figure), .value = value});
}

void add_machine(const LayoutFacts& facts, const LayoutFacts::Machine& machine, FigureRecord& lock) {
    each_population(facts.lines, [&](std::string_view suffix, const auto& of) {
        const auto queries = static_cast<double>(of(facts.lines).queries);
        const MachineMisses& misses = of(machine.steady);
        for (const auto* levels : {&misses.caches, &misses.tlbs}) {
            for (const LevelMisses& level : *levels)
                add(lock, fmt::format("misses_per_query.{}.{}{}", machine.name, level.level, suffix),
                    static_cast<double>(level.misses.all()) / queries);
        }
        add(lock,
            fmt::format("emptied_misses_per_query.{}.{}{}", machine.name, misses.caches.front().level,
                        suffix),
            static_cast<double>(of(machine.emptied)) / queries);
    });
}

}  // namespace

FigureRecord lock_of(const LayoutFacts& facts, Conditions of) {
    FigureRecord lock{"lock", std::move(of), {}, {}, {}};
    std::uint64_t total = 0;
    for (const ComponentBytes& part : facts.bytes) {
        add(lock, "bytes." + part.component, static_cast<double>(part.bytes));
        total += part.bytes;
    }
    add(lock, "bytes", static_cast<double>(total));
    add(lock, "distinct_lines", static_cast<double>(facts.distinct_lines));
    each_population(facts.lines, [&](std::string_view suffix, const auto& population) {
        const LinesTouched& sums = population(facts.lines);
        const auto queries = static_cast<double>(sums.queries);
        add(lock, fmt::format("queries{}", suffix), queries);
        add(lock, fmt::format("lines_per_query{}", suffix), static_cast<double>(sums.lines) / queries);
        add(lock, fmt::format("knee_bytes{}", suffix),
            static_cast<double>(population(facts.knee_bytes).value_or(0)));
    });
    for (const LayoutFacts::Machine& machine : facts.machines) add_machine(facts, machine, lock);
    return lock;
}

int lock_program(int argc, const char* const* argv, const Expected<LayoutFacts>& facts, Conditions of) {
    const bool checks = argc == 3 && std::string_view(argv[1]) == "--check";
    if (argc != 1 && !checks) {
        fmt::print(stderr, "usage: {0} > FILE, or {0} --check FILE\n", argv[0]);
        return 2;
    }
    if (!facts.value) {
        fmt::print(stderr, "{}: {}; {}\n", argv[0], facts.reason, facts.remedy);
        return 2;
    }
    const FigureRecord lock = lock_of(*facts.value, std::move(of));
    if (!checks) {
        fmt::print("{}", to_json(lock));
        return 0;
    }
    try {
        const RecordComparison found = compare(read_record(argv[2], "lock"), lock);
        fmt::print("{}", to_text(found, argv[2]));
        return found.exit_code();
    } catch (const std::exception& problem) {
        fmt::print(stderr, "{}: {}\n", argv[0], problem.what());
        return 2;
    }
}

}  // namespace edgewise::measure
