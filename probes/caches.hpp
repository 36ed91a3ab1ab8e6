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

class caches final : public bench::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "caches"; }
    [[nodiscard]] std::string_view summary() const override {
        return "modelled misses by machine, level, cause, field and step; bytes brought in vain; memory time";
    }

    [[nodiscard]] bool beside_others() const override { return true; }

    [[nodiscard]] bench::Findings measure(const bench::ProbedCell& cell) const override {
        const measure::SceneTrace& trace = bench::scene_trace(cell);
        const std::size_t edges = cell.runner.stored_bodies()[0].edge_count();
        bench::Findings found{figures(trace, static_cast<double>(edges))};
        if (!cell.caches.machines.empty())
            found.figures.push_back(store::figure("caches.identity", cell.caches.identity()));
        if (trace.traced()) found.passed = bench::PassSum{trace.answered, trace.distances};
        return found;
    }

    /// edges: of the scene's first body.
    [[nodiscard]] static std::vector<measure::Figure> figures(const measure::SceneTrace& trace,
                                                              double edges) {
        if (!trace.traced()) return {store::no_figure("caches.misses_per_query", trace.reason, trace.remedy)};
        std::vector<measure::Figure> all;
        for (const measure::ModelledMachine& machine : trace.machines)
            add_machine(machine, trace, edges, all);
        for (const measure::ModelledMachine& machine : trace.policies) {
            for (const measure::LevelMisses& level : machine.steady.caches)
                add(all, trace, store::level_misses.of(machine.name, level.level), level.misses.all());
        }
        return all;
    }

  private:
    static void add(std::vector<measure::Figure>& all, const measure::SceneTrace& trace,
                    const store::FigureName& name, std::uint64_t count) {
        all.push_back(store::figure(name, static_cast<double>(count) / static_cast<double>(trace.queries)));
    }

    static void add_machine(const measure::ModelledMachine& machine, const measure::SceneTrace& trace,
                            double edges, std::vector<measure::Figure>& all) {
        if (!machine.reason.empty()) {
            for (const store::FigureName& name :
                 {store::level_misses.of(machine.name, "L1D"), store::memory_time.of(machine.name)})
                all.push_back(store::no_figure(
                    name, machine.reason, "describe the machine in a JSON file and name it with --machines"));
            return;
        }
        for (std::size_t i = 0; i < machine.steady.caches.size(); ++i)
            add_level(machine, machine.steady.caches[i], machine.first.caches[i], trace, edges, all);
        for (std::size_t i = 0; i < machine.steady.tlbs.size(); ++i)
            add_level(machine, machine.steady.tlbs[i], machine.first.tlbs[i], trace, edges, all);
        for (std::size_t i = 0; i < machine.cold.size(); ++i)
            add(all, trace,
                store::FigureName("caches.{machine}.{level}.cold_misses_per_query")
                    .of(machine.name, machine.steady.caches[i].level),
                machine.cold[i]);
        for (const measure::LevelMisses& level : machine.steady.caches)
            add_breakdown(machine.name, level, trace, all);
        add(all, trace, store::FigureName("caches.{machine}.fetched_bytes_per_query").of(machine.name),
            machine.steady.fetched.bytes);
        add(all, trace, store::FigureName("caches.{machine}.unused_bytes_per_query").of(machine.name),
            machine.steady.fetched.unused);
        all.push_back(memory_time(machine, trace));
    }

    static void add_level(const measure::ModelledMachine& machine, const measure::LevelMisses& steady,
                          const measure::LevelMisses& warm, const measure::SceneTrace& trace, double edges,
                          std::vector<measure::Figure>& all) {
        const auto at = [&](const store::FigureName& name) { return name.of(machine.name, steady.level); };
        add(all, trace, at(store::level_misses), steady.misses.all());
        add(all, trace, at("caches.{machine}.{level}.capacity_per_query"), steady.misses.capacity);
        add(all, trace, at("caches.{machine}.{level}.conflict_per_query"), steady.misses.conflict);
        add(all, trace, at("caches.{machine}.{level}.warm_misses_per_query"), warm.misses.all());
        add(all, trace, at("caches.{machine}.{level}.compulsory_per_query"), warm.misses.compulsory);
        all.push_back(store::figure(
            at("caches.{machine}.{level}.misses_per_edge"),
            static_cast<double>(steady.misses.all()) / static_cast<double>(trace.queries) / edges));
        const double verified = static_cast<double>(warm.misses.compulsory) /
                                static_cast<double>(std::max<std::uint64_t>(warm.first_touches, 1));
        all.push_back(store::figure(at("caches.{machine}.{level}.cold_verified"), verified));
    }

    /// By what was read and by what read it; what was never accessed is left out.
    static void add_breakdown(const std::string& machine, const measure::LevelMisses& level,
                              const measure::SceneTrace& trace, std::vector<measure::Figure>& all) {
        for (std::size_t i = 0; i < trace.fields.size(); ++i) {
            if (trace.heat.by_field[i] == 0) continue;
            add(all, trace,
                store::FigureName("caches.{machine}.{level}.field.{field}")
                    .of(machine, level.level, trace.fields[i]),
                level.by_field[i]);
        }
        for (std::size_t i = 0; i < trace.steps.size(); ++i) {
            if (trace.heat.by_step[i] == 0) continue;
            add(all, trace,
                store::FigureName("caches.{machine}.{level}.step.{step}")
                    .of(machine, level.level, trace.steps[i]),
                level.by_step[i]);
        }
    }

    static measure::Figure memory_time(const measure::ModelledMachine& machine,
                                       const measure::SceneTrace& trace) {
        const auto& ns = machine.steady.memory_ns;
        measure::Figure figure =
            ns ? store::figure(store::memory_time.of(machine.name), *ns / static_cast<double>(trace.queries))
               : store::no_figure(store::memory_time.of(machine.name),
                                  "the latencies of this machine are not known",
                                  "give latency_cycles of every level in a machine file");
        if (!machine.steady.proved) figure.unit += " of unverified latencies";
        return figure;
    }
};

}  // namespace edgewise::probes
