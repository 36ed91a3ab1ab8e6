// SPDX-License-Identifier: MIT
//
// Modelled caches: misses of the scene's first queries (the number that the plan traces) in the caches of
// each chosen machine, and their causes. Emptied: caches are emptied before each query, tables alone. Two
// passes over the same queries: the first starts with every cache empty and fills them as the scene goes, the
// steady pass comes after it and finds what it left. Misses of queries that start cold and warm are counted
// apart by name, in the same pass: cold ones fill the caches for warm ones. That the first pass did start
// empty is checked: every first touch of a line must have missed in every level, so that cold_verified is 1.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/bench/probe.hpp"
#include "edgewise/bench/trace/trace_scene.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::probes {

class caches {
  public:
    static constexpr std::string_view summary =
        "modelled misses by machine, level, cause, field and step; bytes brought in vain; memory time";
    static constexpr bool beside_others = true;

    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell) {
        const measure::SceneTrace& trace = bench::scene_trace(cell);
        const auto edges = static_cast<double>(cell.runner.stored_bodies()[0].edge_count());
        bench::Findings found{figures(trace, edges)};
        if (!cell.caches.machines.empty())
            found.figures.push_back(store::figure("caches.identity", cell.caches.identity()));
        if (trace.traced()) found.passed = bench::PassSum{trace.answered, trace.distances};
        return found;
    }

    /// edges: of the scene's first body.
    [[nodiscard]] static std::vector<measure::Figure> figures(const measure::SceneTrace& trace,
                                                              double edges) {
        if (!trace.traced()) return {store::no_figure("caches.misses_per_query", trace.reason, trace.remedy)};
        caches found(trace, edges);
        for (const measure::ModelledMachine& machine : trace.machines) found.add_machine(machine);
        for (const measure::ModelledMachine& machine : trace.policies) {
            for (std::size_t i = 0; i < machine.steady.all.caches.size(); ++i)
                found.add(store::level_misses.of(machine.name, machine.steady.all.caches[i].level),
                          found.each(machine.steady, &measure::MachineMisses::caches, i,
                                     [](const auto& level) { return level.misses.all(); }));
        }
        return found.all_;
    }

  private:
    caches(const measure::SceneTrace& trace, double edges) : trace_(trace), edges_(edges) {}

    using Sums = measure::ByStart<std::uint64_t>;
    using Levels = std::vector<measure::LevelMisses> measure::MachineMisses::*;

    void add(const store::FigureName& name, std::uint64_t count) {
        all_.push_back(store::mean_figure(name, count, trace_.queries.all));
    }
    void add(const store::StartNames& names, const Sums& counts) {
        store::add_means(names, counts, trace_.queries, all_);
    }
    /// What `count` gives of level i, of all queries and by their start.
    template <class Count>
    [[nodiscard]] static Sums each(const measure::ByStart<measure::MachineMisses>& of, Levels levels,
                                   std::size_t i, const Count& count) {
        return {count((of.all.*levels)[i]), count((of.cold.*levels)[i]), count((of.warm.*levels)[i])};
    }

    void add_machine(const measure::ModelledMachine& machine) {
        if (!machine.reason.empty()) {
            for (const store::FigureName& name :
                 {store::level_misses.all.of(machine.name, "L1D"), store::memory_time.all.of(machine.name)})
                all_.push_back(store::no_figure(
                    name, machine.reason, "describe the machine in a JSON file and name it with --machines"));
            return;
        }
        const measure::MachineMisses& all = machine.steady.all;
        const auto of = [&](const store::FigureName& name) { return name.of(machine.name); };
        for (std::size_t i = 0; i < all.caches.size(); ++i)
            add_level(machine, &measure::MachineMisses::caches, i);
        for (std::size_t i = 0; i < all.tlbs.size(); ++i)
            add_level(machine, &measure::MachineMisses::tlbs, i);
        constexpr store::StartNames emptied{"caches.{machine}.{level}.emptied_misses_per_query",
                                            "caches.{machine}.{level}.emptied_misses_per_query.{start}"};
        for (std::size_t i = 0; i < machine.emptied.all.size(); ++i)
            add(emptied.of(machine.name, all.caches[i].level),
                {machine.emptied.all[i], machine.emptied.cold[i], machine.emptied.warm[i]});
        for (std::size_t i = 0; i < all.caches.size(); ++i) add_breakdown(machine, i);
        add(of("caches.{machine}.fetched_bytes_per_query"), all.fetched.bytes);
        add(of("caches.{machine}.unused_bytes_per_query"), all.fetched.unused);
        add_memory_time(machine);
    }

    void add_level(const measure::ModelledMachine& machine, Levels levels, std::size_t i) {
        const measure::LevelMisses &steady = (machine.steady.all.*levels)[i],
                                   &first = (machine.first.*levels)[i];
        const auto at = [&](const auto& names) { return names.of(machine.name, steady.level); };
        constexpr store::StartNames capacity{"caches.{machine}.{level}.capacity_per_query",
                                             "caches.{machine}.{level}.capacity_per_query.{start}"},
            conflict{"caches.{machine}.{level}.conflict_per_query",
                     "caches.{machine}.{level}.conflict_per_query.{start}"};
        constexpr store::FigureName first_pass("caches.{machine}.{level}.first_pass_misses_per_query"),
            compulsory("caches.{machine}.{level}.compulsory_per_query"),
            per_edge("caches.{machine}.{level}.misses_per_edge"),
            verified("caches.{machine}.{level}.cold_verified");
        using Level = const measure::LevelMisses&;
        add(at(store::level_misses),
            each(machine.steady, levels, i, [](Level level) { return level.misses.all(); }));
        add(at(capacity), each(machine.steady, levels, i, [](Level level) { return level.misses.capacity; }));
        add(at(conflict), each(machine.steady, levels, i, [](Level level) { return level.misses.conflict; }));
        add(at(first_pass), first.misses.all());
        add(at(compulsory), first.misses.compulsory);
        add(at(per_edge), steady.misses.all());
        *all_.back().value /= edges_;
        all_.push_back(store::mean_figure(at(verified), first.misses.compulsory,
                                          std::max<std::uint64_t>(first.first_touches, 1)));
    }

    /// Adds misses by field and by step of the algorithm; fields and steps without accesses are left out.
    void add_breakdown(const measure::ModelledMachine& machine, std::size_t i) {
        constexpr store::StartNames by_field{"caches.{machine}.{level}.field.{field}",
                                             "caches.{machine}.{level}.field.{field}.{start}"},
            by_step{"caches.{machine}.{level}.step.{step}", "caches.{machine}.{level}.step.{step}.{start}"};
        const std::string& level = machine.steady.all.caches[i].level;
        const auto add_all = [&](const store::StartNames& names, const auto& parts, const auto& accesses,
                                 auto misses) {
            for (std::size_t part = 0; part < parts.size(); ++part) {
                if (accesses[part] == 0) continue;
                add(names.of(machine.name, level, parts[part]),
                    each(machine.steady, &measure::MachineMisses::caches, i,
                         [&](const measure::LevelMisses& of) { return (of.*misses)[part]; }));
            }
        };
        add_all(by_field, trace_.fields, trace_.heat.by_field.all, &measure::LevelMisses::by_field);
        add_all(by_step, trace_.steps, trace_.heat.by_step, &measure::LevelMisses::by_step);
    }

    void add_memory_time(const measure::ModelledMachine& machine) {
        const store::StartNames names = store::memory_time.of(machine.name);
        const auto mean = [](const measure::MachineMisses& of,
                             std::uint64_t queries) -> std::optional<double> {
            if (!of.memory_ns || queries == 0) return std::nullopt;
            return *of.memory_ns / static_cast<double>(queries);
        };
        const measure::ByStart<measure::MachineMisses>& steady = machine.steady;
        const std::size_t before = all_.size();
        store::add_values(names,
                          {mean(steady.all, trace_.queries.all), mean(steady.cold, trace_.queries.cold),
                           mean(steady.warm, trace_.queries.warm)},
                          all_);
        for (std::size_t i = before; i < all_.size(); ++i) {
            if (!steady.all.proved) all_[i].unit += " of unverified latencies";
            if (steady.all.memory_ns) continue;
            all_[i].reason = "the latencies of this machine are not known";
            all_[i].remedy = "give latency_cycles of every level in a machine file";
        }
    }

    const measure::SceneTrace& trace_;
    double edges_;
    std::vector<measure::Figure> all_;
};

}  // namespace edgewise::probes
