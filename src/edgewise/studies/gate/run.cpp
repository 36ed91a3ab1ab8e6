// SPDX-License-Identifier: MIT
#include "edgewise/studies/gate/run.hpp"

#include <algorithm>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/studies/gate/group.hpp"

namespace edgewise::studies {

namespace {

measure::FigureRecord record_without_rows(const GatePlan& plan) {
    const store::BuildRow build = bench::this_build();
    return {speed_kind,
            {{"queries", std::to_string(plan.queries)}},
            {{"machine", measure::read_machine().cpu.name.value.value_or("unknown")},
             {"git_revision", build.git_revision},
             {"compiler", build.compiler},
             {"flags", build.flags},
             {"build_type", build.build_type},
             {"rounds", std::to_string(plan.rounds)}},
            {},
            {}};
}

bool is_asked_for(const GatePlan& plan, const std::string& group) {
    return plan.groups.empty() ||
           std::find(plan.groups.begin(), plan.groups.end(), group) != plan.groups.end();
}

/// Returns false if it was stopped.
bool add_group(const GatePlan& plan, const GateScene& scene, const std::string& shape,
               const std::atomic<bool>& stop, GateRun& run) {
    const GateKernel kernel;
    GateGroup group(plan, scene, shape, run.wrong);
    const double clock_cost_ns = measure::calibrate();
    for (int round = 0; round < plan.rounds; ++round) {
        if (stop) return false;
        group.time_round(round, kernel, clock_cost_ns);
    }
    for (measure::RecordRow& row : group.rows()) run.record.rows.push_back(std::move(row));
    return true;
}

}  // namespace

std::vector<std::string> gate_groups() {
    std::vector<std::string> groups;
    for (const GateScene& scene : gate_scenes())
        for (const std::string& shape : gate_shapes()) groups.push_back(gate_group_name(scene.name, shape));
    return groups;
}

std::optional<GateRun> run_gate(const GatePlan& plan,
                                const std::function<void(const std::string& group)>& on_group,
                                const std::atomic<bool>& stop) {
    GateRun run{record_without_rows(plan), {}};
    for (const GateScene& scene : gate_scenes()) {
        for (const std::string& shape : gate_shapes()) {
            const std::string name = gate_group_name(scene.name, shape);
            if (!is_asked_for(plan, name)) continue;
            if (!add_group(plan, scene, shape, stop, run)) return std::nullopt;
            on_group(name);
        }
    }
    return run;
}

}  // namespace edgewise::studies
