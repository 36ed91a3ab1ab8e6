// SPDX-License-Identifier: MIT
//
// Modelled caches: what the scene's first queries (as many as the plan traces) miss in the caches of each
// chosen machine, and why. Cold: caches are emptied before each query, tables alone. Two passes over the same
// queries: `warm` starts with every cache empty and fills them as the scene goes, `steady` comes after it and
// finds what it left. That the first pass did start empty is checked: every first touch of a line must have
// missed in every level, so that cold_verified is 1.
#pragma once

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
            for (const measure::LevelMisses& level : machine.steady.caches)
                found.add(store::level_misses.of(machine.name, level.level), level.misses.all());
        }
        return found.all_;
    }

  private:
    caches(const measure::SceneTrace& trace, double edges) : trace_(trace), edges_(edges) {}

    void add(const store::FigureName& name, std::uint64_t count) {
        all_.push_back(store::mean_figure(name, count, trace_.queries));
    }

    void add_machine(const measure::ModelledMachine& machine) {
        if (!machine.reason.empty()) {
            for (const store::FigureName& name :
                 {store::level_misses.of(machine.name, "L1D"), store::memory_time.of(machine.name)})
                all_.push_back(store::no_figure(
                    name, machine.reason, "describe the machine in a JSON file and name it with --machines"));
            return;
        }
        const auto of = [&](const store::FigureName& name) { return name.of(machine.name); };
        for (std::size_t i = 0; i < machine.steady.caches.size(); ++i)
            add_level(machine, machine.steady.caches[i], machine.first.caches[i]);
        for (std::size_t i = 0; i < machine.steady.tlbs.size(); ++i)
            add_level(machine, machine.steady.tlbs[i], machine.first.tlbs[i]);
        for (std::size_t i = 0; i < machine.cold.size(); ++i)
            add(store::FigureName("caches.{machine}.{level}.cold_misses_per_query")
                    .of(machine.name, machine.steady.caches[i].level),
                machine.cold[i]);
        for (const measure::LevelMisses& level : machine.steady.caches) add_breakdown(machine.name, level);
        add(of("caches.{machine}.fetched_bytes_per_query"), machine.steady.fetched.bytes);
        add(of("caches.{machine}.unused_bytes_per_query"), machine.steady.fetched.unused);
        add_memory_time(machine);
    }

    void add_level(const measure::ModelledMachine& machine, const measure::LevelMisses& steady,
                   const measure::LevelMisses& warm) {
        const auto at = [&](const store::FigureName& name) { return name.of(machine.name, steady.level); };
        add(at(store::level_misses), steady.misses.all());
        add(at("caches.{machine}.{level}.capacity_per_query"), steady.misses.capacity);
        add(at("caches.{machine}.{level}.conflict_per_query"), steady.misses.conflict);
        add(at("caches.{machine}.{level}.warm_misses_per_query"), warm.misses.all());
        add(at("caches.{machine}.{level}.compulsory_per_query"), warm.misses.compulsory);
        all_.push_back(store::mean_figure(at("caches.{machine}.{level}.misses_per_edge"), steady.misses.all(),
                                          trace_.queries));
        *all_.back().value /= edges_;
        all_.push_back(store::mean_figure(at("caches.{machine}.{level}.cold_verified"),
                                          warm.misses.compulsory,
                                          std::max<std::uint64_t>(warm.first_touches, 1)));
    }

    /// By what was read and by what read it; what was never accessed is left out.
    void add_breakdown(const std::string& machine, const measure::LevelMisses& level) {
        const auto add_all = [&](const store::FigureName& name, const auto& parts, const auto& accesses,
                                 const auto& misses) {
            for (std::size_t i = 0; i < parts.size(); ++i)
                if (accesses[i] > 0) add(name.of(machine, level.level, parts[i]), misses[i]);
        };
        add_all("caches.{machine}.{level}.field.{field}", trace_.fields, trace_.heat.by_field,
                level.by_field);
        add_all("caches.{machine}.{level}.step.{step}", trace_.steps, trace_.heat.by_step, level.by_step);
    }

    void add_memory_time(const measure::ModelledMachine& machine) {
        const auto& ns = machine.steady.memory_ns;
        const auto queries = static_cast<double>(trace_.queries);
        all_.push_back(store::figure(store::memory_time.of(machine.name),
                                     ns ? std::optional(*ns / queries) : std::nullopt,
                                     "the latencies of this machine are not known",
                                     "give latency_cycles of every level in a machine file"));
        if (!machine.steady.proved) all_.back().unit += " of unverified latencies";
    }

    const measure::SceneTrace& trace_;
    double edges_;
    std::vector<measure::Figure> all_;
};

}  // namespace edgewise::probes
