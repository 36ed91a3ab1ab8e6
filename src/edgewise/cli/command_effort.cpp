// SPDX-License-Identifier: MIT
//
// `edgewise bench effort`: where the work of queries goes, of our table types and of other libraries:
// instructions, modelled mispredictions and misses per query and per step, next to a lower bound.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/peers/peer_modules.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/studies/effort/effort.hpp"
#include "edgewise/studies/phases/phases.hpp"

namespace edgewise::cli {

namespace {

using studies::EffortByPhase, studies::PhaseEffort;

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
        {"code_bytes", counted ? nlohmann::json(row.code_bytes) : nlohmann::json()},
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
    if (row.phases.empty())
        return fmt::print("  not counted: {}{}{}\n", row.reason, row.remedy.empty() ? "" : "; ", row.remedy);
    fmt::print("code that ran: {} bytes in lines of 64\n", row.code_bytes);
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

/// --by-phase: what runs once a query apart from what each step takes. A check failed where an answer is
/// wrong, or phases do not add up to what Callgrind counted.
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
    const bool nothing = std::ranges::all_of(rows, [](const auto& row) { return row.phases.empty(); });
    if (nothing) warn("nothing was counted; each row says why");
    int code = nothing ? exit_check_failed : exit_done;
    for (const EffortByPhase& row : rows) {
        if (row.wrong.empty()) continue;
        warn(fmt::format("{} {}: {}", row.table, row.algorithm, row.wrong));
        code = exit_check_failed;
    }
    return code;
}

/// Without the parameters of its scene, which another scene may not have.
studies::CellChoice plain_cell() {
    studies::CellChoice cell = studies::effort_cell;
    cell.parameters.clear();
    return cell;
}

struct EffortArguments {
    studies::CellChoice cell = plain_cell();
    std::vector<std::string> layouts = {"aos_f64", "lean_f32", "points_soa_f64"}, algorithms = {"all"}, peers;
    std::vector<std::string> machines = {studies::effort_machine};  ///< one
    std::string store;
    bool by_phase = false;
};

studies::EffortPlan plan_of(const EffortArguments& options) {
    studies::CellChoice cell = options.cell;
    if (cell.scene == studies::effort_cell.scene)  // what was named goes before
        cell.parameters.insert(studies::effort_cell.parameters.begin(),
                               studies::effort_cell.parameters.end());
    studies::EffortPlan plan = {
        cell, bench::select_table_types(options.layouts), bench::select_peer_types(options.peers),
        bench::select_algorithms(options.algorithms), measure::choose_machines(options.machines).front()};
    if (studies::contenders(plan).empty())
        throw std::invalid_argument("none of these layouts serves any of these algorithms");
    return plan;
}

nlohmann::json effort_json(const store::StoredCell& row) {
    nlohmann::json figures = nlohmann::json::object();
    for (const store::FigureRow& figure : row.figures) {
        figures[figure.probe + "." + figure.name] = {{"value", or_null(figure.value)},
                                                     {"unit", figure.unit},
                                                     {"reason", or_null(figure.reason)},
                                                     {"remedy", or_null(figure.remedy)}};
    }
    return {{"table", row.table}, {"algorithm", row.algorithm},      {"scene", row.scene},
            {"shape", row.shape}, {"status", to_string(row.status)}, {"reason", or_null(row.reason)},
            {"figures", figures}};
}

/// The report's tables of an effort run.
void print(const std::vector<store::StoredCell>& rows, const studies::EffortPlan& plan) {
    reports::ReportData data;
    for (const store::StoredCell& row : rows) data.effort.push_back({row, row.scene});
    fmt::print("per query of {} on {}, caches of {}\n", plan.cell.scene, plan.cell.shape, plan.machine.name);
    for (const reports::TextGrid& grid :
         {reports::effort_grid(data), reports::effort_floor_grid(data), reports::problems_grid(data)})
        if (!grid.rows.empty()) fmt::print("\n{}", grid_text(grid));
    fmt::print(
        "\nMispredictions and misses are Callgrind's models. The floor proves a known answer by heights of "
        "vertices.\n");
}

/// In the plan's order; those that the store already has are not in it.
bool measure_rows(const EffortArguments& options, const studies::EffortPlan& plan,
                  std::vector<store::StoredCell>& rows) {
    std::vector<std::optional<store::StoredCell>> places(studies::contenders(plan).size());
    Progress progress("effort", places.size());
    const auto take = [&](std::size_t place, const store::StoredCell& row) {
        places[place] = row;
        progress.advance(1, row.table + " " + row.algorithm);
    };
    const std::atomic<bool>& stop = stop_on_signals();
    bool done = false;
    if (options.store.empty()) {
        done = studies::run_effort(
            plan, [](const store::CellRow&) { return true; }, take, stop);
    } else {
        store::Store store(options.store);
        const store::BuildRow build = bench::this_build();
        store.put_build(build);
        done = studies::store_effort(plan, build.id, store, take, stop);
    }
    progress.clear();
    for (auto& row : places)
        if (row) rows.push_back(std::move(*row));
    if (done && rows.size() < places.size())
        warn(fmt::format("{} of {} rows are in {} already", places.size() - rows.size(), places.size(),
                         options.store));
    return done;
}

int run_effort(const EffortArguments& options, bool json) {
    const studies::EffortPlan plan = plan_of(options);
    if (options.by_phase) return print_phases(plan, json);
    std::vector<store::StoredCell> rows;
    if (!measure_rows(options, plan, rows)) return exit_check_failed;
    if (json) {
        print_json(
            nlohmann::json({{"effort", json_rows(rows, effort_json)}, {"machine", plan.machine.name}}));
    } else {
        print(rows, plan);
    }
    const auto has = [](store::CellStatus status) {
        return [status](const store::StoredCell& row) { return row.status == status; };
    };
    const bool nothing = !rows.empty() && std::ranges::all_of(rows, has(store::CellStatus::unavailable));
    if (nothing) warn("nothing was measured; each row says why");
    return nothing || std::ranges::any_of(rows, has(store::CellStatus::failed)) ? exit_check_failed
                                                                                : exit_done;
}

}  // namespace

void add_effort(CLI::App& bench, Context& context) {
    auto [command, options] = add_command(
        bench, context, "effort",
        "Instructions, modelled mispredictions and misses per query and step, next to a lower bound",
        run_effort);
    add_scene_options(*command, options.cell);
    refuse_recordings(*command);
    add_layouts_option(*command, options.layouts);
    add_algorithms_option(*command, options.algorithms);
    CLI::Option* peers = add_peers_option(*command, options.peers);
    add_checked_option(*command, options.cell.checked);
    add_machines_option(*command, options.machines)
        ->delimiter('\0')  // the sizes of one machine have commas
        ->expected(1)
        ->allow_extra_args(false)
        ->default_str(studies::effort_machine);
    CLI::Option* store =
        add_store_option(*command, options.store, "rows are added, and those it has are left as they are");
    command
        ->add_flag("--by-phase", options.by_phase,
                   "what they are divided by the phases of the algorithm, of our table types alone")
        ->excludes(peers)
        ->excludes(store);
}

}  // namespace edgewise::cli
