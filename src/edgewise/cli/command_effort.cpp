// SPDX-License-Identifier: MIT
//
// `edgewise effort`: where the work of queries goes, of our table types and of other libraries: instructions,
// modelled mispredictions and misses per query and per step, beside a floor.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/peers/peer_modules.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/number_option.hpp"
#include "edgewise/cli/terminal/phase_tables.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/studies/effort_rows.hpp"

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
    std::string machine = studies::effort_machine;
    std::string store;
    bool by_phase = false;
};

studies::EffortPlan plan_of(const EffortArguments& options) {
    const std::string machines[] = {options.machine};
    studies::CellChoice cell = options.cell;
    if (cell.scene == studies::effort_cell.scene)  // what was named goes before
        cell.parameters.insert(studies::effort_cell.parameters.begin(),
                               studies::effort_cell.parameters.end());
    return {cell, bench::select_table_types(options.layouts), bench::select_peer_types(options.peers),
            bench::select_algorithms(options.algorithms), measure::choose_machines(machines).front()};
}

const store::FigureRow* find(const studies::EffortRow& row, const store::FigureName& name) {
    for (const store::FigureRow& figure : row.figures)
        if (figure.probe == name.probe() && figure.name == name.name()) return &figure;
    return nullptr;
}

nlohmann::json json_of(const studies::EffortRow& row) {
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

struct Column {
    const char* title;
    store::FigureName figure;
};

std::array<Column, 12> columns_for(const std::string& machine) {
    constexpr store::FigureName d1("effort.{machine}.d1_misses"), ll("effort.{machine}.ll_misses");
    return {{{"instr.", "effort.instructions"},
             {"mispred.", "effort.mispredictions"},
             {"D1 miss", d1.of(machine)},
             {"LL miss", ll.of(machine)},
             {"steps", "effort.steps"},
             {"supports", "effort.supports"},
             {"vertices", "effort.vertices_read"},
             {"lines", "effort.lines_read"},
             {"in./step", "effort.instructions_per_step"},
             {"in./floor", "effort.instructions_over_floor"},
             {"li./floor", "effort.lines_over_floor"},
             {"bytes", "bytes.table_bytes"}}};
}

void print_row(const studies::EffortRow& row, const std::string& machine) {
    fmt::print("{:<26} {:<22}", row.cell.table, row.cell.algorithm);
    for (const Column& column : columns_for(machine)) {
        const store::FigureRow* figure = find(row, column.figure);
        fmt::print(" {:>9}", figure && figure->value ? fmt::format("{:.2f}", *figure->value) : "-");
    }
    fmt::print("\n");
    const store::FigureRow* counted = find(row, "effort.instructions");
    const bool lacks = counted && !counted->value;
    if (lacks) fmt::print("  not counted: {}; {}\n", counted->reason, counted->remedy);
    if (!row.cell.reason.empty()) fmt::print("  {}: {}\n", to_string(row.cell.status), row.cell.reason);
}

void print(const std::vector<studies::EffortRow>& rows, const EffortArguments& options) {
    fmt::print("per query of {} on {}, caches of {}\n", options.cell.scene, options.cell.shape,
               options.machine);
    fmt::print("{:<26} {:<22}", "table type or library", "algorithm");
    for (const Column& column : columns_for(options.machine)) fmt::print(" {:>9}", column.title);
    fmt::print("\n");
    for (const studies::EffortRow& row : rows) print_row(row, options.machine);
    const auto floor = [&](const store::FigureName& name) {
        const store::FigureRow* figure = rows.empty() ? nullptr : find(rows.front(), name);
        return figure && figure->value ? fmt::format("{:.2f}", *figure->value) : "-";
    };
    fmt::print(
        "Mispredictions and misses are Callgrind's models. The floor proves a known answer by heights of vertices: "
        "{} vertices, {} flops, {} lines for the first row; instructions are divided by its flops, lines by "
        "its lines. '-': --json says why.\n",
        floor("effort.floor_vertices"), floor("effort.floor_flops"), floor("effort.floor_lines"));
}

/// In the plan's order; those that the store already has are not in it.
bool measure_rows(const EffortArguments& options, const studies::EffortPlan& plan,
                  std::vector<studies::EffortRow>& rows) {
    std::vector<std::optional<studies::EffortRow>> places(studies::effort_rows(plan));
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
        nlohmann::json all = nlohmann::json::array();
        for (const studies::EffortRow& row : rows) all.push_back(json_of(row));
        print_json(nlohmann::json({{"effort", all}, {"machine", options.machine}}));
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

void add_effort(CLI::App& app, Context& context) {
    auto [command, options] = add_command(
        app, context, "effort",
        "Instructions, modelled mispredictions and misses per query and step, beside a floor", run_effort);
    add_scene_options(*command, options.cell);
    add_names(*command, "--layouts", options.layouts, "table types");
    add_names(*command, "--algorithms", options.algorithms, "algorithms");
    add_names(*command, "--peers", options.peers, "these libraries beside them, or all that are built");
    add_count(*command, "--checked", options.cell.checked, input::queries_range,
              "queries checked exactly per row");
    command->add_option("--machine", options.machine, "whose first two levels: a name, or your NAME.json")
        ->capture_default_str();
    CLI::Option* peers = command->get_option("--peers");
    CLI::Option* store = command->add_option(
        "--store", options.store, "SQLite file to add the rows to; those it has are left as they are");
    command
        ->add_flag("--by-phase", options.by_phase,
                   "what they are divided by the phases of the algorithm, of our table types alone")
        ->excludes(peers)
        ->excludes(store);
}

}  // namespace edgewise::cli
