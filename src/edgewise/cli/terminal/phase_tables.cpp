// SPDX-License-Identifier: MIT
#include "edgewise/cli/terminal/phase_tables.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "edgewise/cli/command.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/studies/phases/phases.hpp"

namespace edgewise::cli {

namespace {

using studies::EffortByPhase;
using studies::PhaseEffort;

/// A part of `other` above which the table of phases wants a look, in per cent of the instructions.
constexpr double much_other = 3;

nlohmann::json json_of(const PhaseEffort& phase, const PhaseEffort& total, double steps) {
    const auto each = [&](double of_query) { return steps > 0 ? nlohmann::json(of_query / steps) : nullptr; };
    return {{"phase", phase.phase},
            {"instructions", phase.instructions},
            {"part_of_instructions", phase.instructions / total.instructions},
            {"mispredictions", phase.mispredictions},
            {"d1_misses", phase.d1_misses},
            {"instructions_once", phase.instructions - phase.instructions_in_steps},
            {"instructions_in_steps", phase.instructions_in_steps},
            {"instructions_per_step", each(phase.instructions)},
            {"mispredictions_per_step", each(phase.mispredictions)},
            {"d1_misses_per_step", each(phase.d1_misses)}};
}

nlohmann::json phases_json(const EffortByPhase& row) {
    const bool counted = !row.phases.empty();
    return {
        {"table", row.table},
        {"algorithm", row.algorithm},
        {"steps", row.steps},
        {"wrong", or_null(row.wrong)},
        {"reason", or_null(row.reason)},
        {"remedy", or_null(counted ? std::string() : row.remedy)},
        {"phases", json_rows(row.phases,
                             [&](const PhaseEffort& phase) { return json_of(phase, row.total, row.steps); })},
        {"others", row.others},
        {"total", counted ? json_of(row.total, row.total, row.steps) : nlohmann::json()}};
}

void print_row(const EffortByPhase& row) {
    fmt::print("{} {}, {:.2f} steps per query\n", row.table, row.algorithm, row.steps);
    if (!row.wrong.empty()) fmt::print("  wrong: {}\n", row.wrong);
    if (row.phases.empty()) {
        fmt::print("  not counted: {}{}{}\n", row.reason, row.remedy.empty() ? "" : "; ", row.remedy);
        return;
    }
    const nlohmann::json json = phases_json(row);
    nlohmann::json rows = json["phases"];
    rows.push_back(json["total"]);
    fmt::print("{}", reports::rows_text(
                         rows, fmt::format("phase|#instr. = instructions|#% = part_of_instructions 0.01 1|"
                                           "#once = instructions_once|#each step = instructions_in_steps {}|"
                                           "#mispred. = mispredictions|#D1 miss = d1_misses",
                                           row.steps)));
    for (const PhaseEffort& phase : row.phases)
        if (phase.phase == studies::other_phase &&
            phase.instructions > much_other / 100 * row.total.instructions)
            fmt::print("of other, most: {}\n", fmt::join(row.others, "; "));
}

}  // namespace

int print_phases(const studies::EffortPlan& plan, bool json) {
    const std::vector<EffortByPhase> rows = studies::effort_by_phase(plan);
    if (json) {
        print_json(nlohmann::json(
            {{"effort_by_phase", json_rows(rows, phases_json)}, {"machine", plan.machine.name}}));
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
