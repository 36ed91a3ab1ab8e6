// SPDX-License-Identifier: MIT
#include "edgewise/cli/terminal/phase_tables.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "edgewise/cli/command.hpp"
#include "edgewise/studies/phases/phases.hpp"

namespace edgewise::cli {

namespace {

using studies::EffortByPhase;
using studies::PhaseEffort;

/// A part of `other` above which the table of phases wants a look, in per cent of the instructions.
constexpr double much_other = 3;

nlohmann::json json_of(const PhaseEffort& phase, double steps) {
    const auto each = [&](double of_query) { return steps > 0 ? nlohmann::json(of_query / steps) : nullptr; };
    return {{"phase", phase.phase},
            {"instructions", phase.instructions},
            {"mispredictions", phase.mispredictions},
            {"d1_misses", phase.d1_misses},
            {"instructions_once", phase.instructions - phase.instructions_in_steps},
            {"instructions_in_steps", phase.instructions_in_steps},
            {"instructions_per_step", each(phase.instructions)},
            {"mispredictions_per_step", each(phase.mispredictions)},
            {"d1_misses_per_step", each(phase.d1_misses)}};
}

nlohmann::json json_of(const EffortByPhase& row) {
    nlohmann::json phases = nlohmann::json::array();
    for (const PhaseEffort& phase : row.phases) phases.push_back(json_of(phase, row.steps));
    const bool counted = !row.phases.empty();
    return {{"table", row.table},
            {"algorithm", row.algorithm},
            {"steps", row.steps},
            {"wrong", or_null(row.wrong)},
            {"reason", or_null(row.reason)},
            {"remedy", or_null(counted ? std::string() : row.remedy)},
            {"phases", phases},
            {"others", row.others},
            {"total", counted ? json_of(row.total, row.steps) : nlohmann::json()}};
}

void print_line(const PhaseEffort& phase, const PhaseEffort& total, double steps) {
    const double once = phase.instructions - phase.instructions_in_steps;
    fmt::print("  {:<30} {:>9.2f} {:>6.1f} {:>9.2f} {:>9.2f} {:>9.3f} {:>9.3f}\n", phase.phase,
               phase.instructions, 100 * phase.instructions / total.instructions, once,
               phase.instructions_in_steps / steps, phase.mispredictions, phase.d1_misses);
}

void print_row(const EffortByPhase& row) {
    fmt::print("{} {}, {:.2f} steps per query\n", row.table, row.algorithm, row.steps);
    if (!row.wrong.empty()) fmt::print("  wrong: {}\n", row.wrong);
    if (row.phases.empty()) {
        fmt::print("  not counted: {}{}{}\n", row.reason, row.remedy.empty() ? "" : "; ", row.remedy);
        return;
    }
    fmt::print("  {:<30} {:>9} {:>6} {:>9} {:>9} {:>9} {:>9}\n", "phase", "instr.", "%", "once", "each step",
               "mispred.", "D1 miss");
    for (const PhaseEffort& phase : row.phases) {
        print_line(phase, row.total, row.steps);
        if (phase.phase == studies::other_phase &&
            phase.instructions > much_other / 100 * row.total.instructions)
            fmt::print("  of other, most: {}\n", fmt::join(row.others, "; "));
    }
    print_line(row.total, row.total, row.steps);
}

}  // namespace

int print_phases(const studies::EffortPlan& plan, bool json) {
    const std::vector<EffortByPhase> rows = studies::effort_by_phase(plan);
    if (json) {
        nlohmann::json all = nlohmann::json::array();
        for (const EffortByPhase& row : rows) all.push_back(json_of(row));
        print_json(nlohmann::json({{"effort_by_phase", all}, {"machine", plan.machine.name}}));
    } else {
        fmt::print("per query of {} on {}, caches of {}\n", plan.cell.scene, plan.cell.shape,
                   plan.machine.name);
        for (const EffortByPhase& row : rows) print_row(row);
        fmt::print("instr. = once + each step x steps. Mispredictions and misses are Callgrind's models.\n");
    }
    int code = exit_done;
    for (const EffortByPhase& row : rows) {
        if (row.wrong.empty()) continue;
        warn(fmt::format("{} {}: {}", row.table, row.algorithm, row.wrong));
        code = exit_check_failed;
    }
    return code;
}

}  // namespace edgewise::cli
