// SPDX-License-Identifier: MIT
//
// `edgewise bench effort`: where the work of queries goes, of our table types and of other libraries:
// instructions, modelled mispredictions and misses per query and per step, next to a lower bound.
#include <fmt/format.h>

#include <algorithm>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/peers/peer_modules.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/cli/terminal/phase_tables.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/studies/effort/effort.hpp"

namespace edgewise::cli {

namespace {

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
    return {cell, bench::select_table_types(options.layouts), bench::select_peer_types(options.peers),
            bench::select_algorithms(options.algorithms), measure::choose_machines(options.machines).front()};
}

nlohmann::json effort_json(const studies::EffortRow& row) {
    nlohmann::json figures = nlohmann::json::object();
    for (const store::FigureRow& figure : row.figures) {
        figures[figure.probe + "." + figure.name] = {{"value", or_null(figure.value)},
                                                     {"unit", figure.unit},
                                                     {"reason", or_null(figure.reason)},
                                                     {"remedy", or_null(figure.remedy)}};
    }
    return {{"table", row.cell.table},
            {"algorithm", row.cell.algorithm},
            {"scene", row.cell.scene},
            {"shape", row.cell.shape},
            {"status", to_string(row.cell.status)},
            {"reason", or_null(row.cell.reason)},
            {"figures", figures}};
}

/// The report's tables of an effort run.
void print(const std::vector<studies::EffortRow>& rows, const EffortArguments& options) {
    reports::ReportData data;
    for (const studies::EffortRow& row : rows)
        data.effort.push_back({{row.cell, row.figures}, row.cell.scene});
    fmt::print("per query of {} on {}, caches of {}\n", options.cell.scene, options.cell.shape,
               options.machines.front());
    for (const reports::TextGrid& grid :
         {reports::effort_grid(data), reports::effort_floor_grid(data), reports::problems_grid(data)})
        if (!grid.rows.empty()) fmt::print("\n{}", grid_text(grid));
    fmt::print(
        "\nMispredictions and misses are Callgrind's models. The floor proves a known answer by heights of "
        "vertices.\n");
}

/// In the plan's order; those that the store already has are not in it.
bool measure_rows(const EffortArguments& options, const studies::EffortPlan& plan,
                  std::vector<studies::EffortRow>& rows) {
    std::vector<std::optional<studies::EffortRow>> places(studies::contenders(plan).size());
    Progress progress("effort", places.size());
    const auto take = [&](std::size_t place, const studies::EffortRow& row) {
        places[place] = row;
        progress.advance(1, row.cell.table + " " + row.cell.algorithm);
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
    std::vector<studies::EffortRow> rows;
    if (!measure_rows(options, plan, rows)) return exit_check_failed;
    if (json) {
        print_json(nlohmann::json(
            {{"effort", json_rows(rows, effort_json)}, {"machine", options.machines.front()}}));
    } else {
        print(rows, options);
    }
    const auto has = [](store::CellStatus status) {
        return [status](const studies::EffortRow& row) { return row.cell.status == status; };
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
    add_layouts_option(*command, options.layouts);
    add_algorithms_option(*command, options.algorithms);
    CLI::Option* peers = add_peers_option(*command, options.peers);
    add_checked_option(*command, options.cell.checked);
    add_machines_option(*command, options.machines)
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
