// SPDX-License-Identifier: MIT
//
// Modelled caches: what the scene's first queries (as many as the plan traces) miss in the caches of each
// chosen machine, and why. Cold: caches are emptied before each query, tables alone. Two passes over the same
// queries: `warm` starts with every cache empty and fills them as the scene goes, `steady` comes after it and
// finds what it left. That the first pass did start empty is checked: every first touch of a line must have
// missed in every level, so that cold_verified is 1.
#pragma once

#include "edgewise/measure/probe.hpp"

namespace edgewise::probes {

class caches final : public measure::Probe {
  public:
    [[nodiscard]] std::string_view name() const override { return "caches"; }
    [[nodiscard]] std::string_view summary() const override {
        return "modelled misses by machine, level, cause, field and step; bytes brought in vain; memory time";
    }

    [[nodiscard]] std::vector<measure::Figure> figures(const measure::Subject& subject) const override {
        const measure::SceneTrace& trace = *subject.trace;
        if (!trace.traced())
            return {{"misses_per_query", std::nullopt, "misses", trace.reason, trace.remedy}};
        std::vector<measure::Figure> all;
        for (const measure::ModelledMachine& machine : trace.machines) add_machine(machine, subject, all);
        for (const measure::ModelledMachine& machine : trace.policies) {
            for (const measure::LevelMisses& level : machine.steady.caches)
                add(all, trace, machine.name + "." + level.level + ".misses_per_query", level.misses.all());
        }
        return all;
    }

  private:
    static void add(std::vector<measure::Figure>& all, const measure::SceneTrace& trace,
                    const std::string& name, std::uint64_t count, const char* unit = "misses") {
        all.push_back({name, static_cast<double>(count) / static_cast<double>(trace.queries), unit});
    }

    static void add_machine(const measure::ModelledMachine& machine, const measure::Subject& subject,
                            std::vector<measure::Figure>& all) {
        const measure::SceneTrace& trace = *subject.trace;
        if (!machine.reason.empty()) {
            for (const char* name : {".L1D.misses_per_query", ".modelled_memory_ns"})
                all.push_back({machine.name + name, std::nullopt, "misses", machine.reason,
                               "describe the machine in a JSON file and name it with --machines"});
            return;
        }
        for (std::size_t i = 0; i < machine.steady.caches.size(); ++i)
            add_level(machine, machine.steady.caches[i], machine.first.caches[i], subject, all);
        for (std::size_t i = 0; i < machine.steady.tlbs.size(); ++i)
            add_level(machine, machine.steady.tlbs[i], machine.first.tlbs[i], subject, all);
        for (std::size_t i = 0; i < machine.cold.size(); ++i)
            add(all, trace, machine.name + "." + machine.steady.caches[i].level + ".cold_misses_per_query",
                machine.cold[i]);
        for (const measure::LevelMisses& level : machine.steady.caches)
            add_breakdown(machine.name, level, trace, all);
        add(all, trace, machine.name + ".fetched_bytes_per_query", machine.steady.fetched.bytes, "B");
        add(all, trace, machine.name + ".unused_bytes_per_query", machine.steady.fetched.unused, "B");
        all.push_back(memory_time(machine, trace));
    }

    static void add_level(const measure::ModelledMachine& machine, const measure::LevelMisses& steady,
                          const measure::LevelMisses& warm, const measure::Subject& subject,
                          std::vector<measure::Figure>& all) {
        const measure::SceneTrace& trace = *subject.trace;
        const std::string at = machine.name + "." + steady.level + ".";
        add(all, trace, at + "misses_per_query", steady.misses.all());
        add(all, trace, at + "capacity_per_query", steady.misses.capacity);
        add(all, trace, at + "conflict_per_query", steady.misses.conflict);
        add(all, trace, at + "warm_misses_per_query", warm.misses.all());
        add(all, trace, at + "compulsory_per_query", warm.misses.compulsory);
        all.push_back({at + "misses_per_edge",
                       static_cast<double>(steady.misses.all()) / static_cast<double>(trace.queries) /
                           static_cast<double>(subject.table.edges),
                       "misses"});
        const double verified = static_cast<double>(warm.misses.compulsory) /
                                static_cast<double>(std::max<std::uint64_t>(warm.first_touches, 1));
        all.push_back({at + "cold_verified", verified, "1"});
    }

    /// By what was read and by what read it; what was never accessed is left out.
    static void add_breakdown(const std::string& machine, const measure::LevelMisses& level,
                              const measure::SceneTrace& trace, std::vector<measure::Figure>& all) {
        const std::string at = machine + "." + level.level + ".";
        for (std::size_t i = 0; i < trace.fields.size(); ++i) {
            if (trace.heat.by_field[i] == 0) continue;
            add(all, trace, at + "field." + std::string(trace.fields[i]), level.by_field[i]);
        }
        for (std::size_t i = 0; i < trace.steps.size(); ++i) {
            if (trace.heat.by_step[i] == 0) continue;
            add(all, trace, at + "step." + std::string(trace.steps[i]), level.by_step[i]);
        }
    }

    static measure::Figure memory_time(const measure::ModelledMachine& machine,
                                       const measure::SceneTrace& trace) {
        const std::string name = machine.name + ".modelled_memory_ns";
        const char* const unit = machine.steady.proved ? "ns, model" : "ns, model of unverified latencies";
        if (!machine.steady.memory_ns) {
            return {name, std::nullopt, unit, "the latencies of this machine are not known",
                    "give latency_cycles of every level in a machine file"};
        }
        return {name, *machine.steady.memory_ns / static_cast<double>(trace.queries), unit};
    }
};

}  // namespace edgewise::probes
