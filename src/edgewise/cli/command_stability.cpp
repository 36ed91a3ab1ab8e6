// SPDX-License-Identifier: MIT
//
// `edgewise stability`: the hard families through every algorithm and table type, judged exactly, into the
// store.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "edgewise/cli/options.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/studies/stability/stability.hpp"
#include "edgewise/sweep/stored_cells.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::cli {

namespace {

struct StabilityArguments {
    studies::StabilityPlan plan;
    std::string store = default_store, shard, costs;
    std::vector<std::string> layouts = {"all"}, algorithms = {"all"}, shapes;
    bool as_stored = false;
};

/// The named bodies, or hulls of the usual mesh files, of which those that cannot be read are passed over;
/// none where no family asks for them.
std::vector<Polyhedron> real_bodies(const StabilityArguments& options) {
    const auto& families = options.plan.families;
    scene::refuse_as_stored_without_mesh(options.as_stored, options.shapes);
    if (!families.empty() && std::ranges::find(families, studies::real_family) == families.end()) {
        if (!options.shapes.empty())
            throw std::invalid_argument(fmt::format(
                "--shape is of the family {}: add it, or leave --shape out", studies::real_family));
        return {};
    }
    sweep::Plan plan = sweep::make_plan("quick");
    plan.shapes.clear();
    if (!options.shapes.empty()) {
        take_bodies(options.shapes, plan);
        plan.as_stored = options.as_stored;
    }
    std::vector<Polyhedron> bodies;
    for (scene::NamedShape& shape : sweep::shapes_of(plan, warn)) {
        if (shape.error.empty()) bodies.push_back(std::move(shape.body));
    }
    return bodies;
}

/// Returns false if it was stopped. The rows are kept for the table at the end.
bool run_with_progress(const studies::StabilityPlan& plan, store::Store& store, reports::ReportData& data) {
    Progress progress("stability", studies::stability_rows(plan), 0, "rows");
    const auto take = [&](const store::StoredCell& row) {
        data.stability.push_back({row, row.scene});
        progress.advance(1, row.shape + " " + row.table);
    };
    return studies::run_stability(plan, store, take, stop_on_signals());
}

/// The report's table of a stability run, and what failed.
void print(const reports::ReportData& data) {
    reports::TextGrid grid = reports::stability_grid(data);
    drop_zero_columns(grid);
    fmt::print("{}{}\n", grid_text(grid), grid.caption);
    if (const reports::TextGrid problems = reports::problems_grid(data); !problems.rows.empty())
        fmt::print("\n{}", grid_text(problems));
}

int run_stability(const StabilityArguments& options, bool json) {
    check_folder_of(options.store, "--store");
    studies::StabilityPlan plan = options.plan;
    plan.types = bench::select_table_types(options.layouts);
    plan.algorithms = bench::select_algorithms(options.algorithms);
    plan.real = real_bodies(options);
    static_cast<void>(studies::stability_rows(plan));  // refuses unknown families before a store is made
    const sweep::Shard shard = chosen_shard(options.shard);
    const auto seconds =
        options.costs.empty() ? std::map<std::string, double>() : sweep::seconds_in(options.costs);
    const bool any = studies::keep_shard(plan, shard, seconds);
    make_folder_of(options.store, "--store");
    store::Store store(options.store);
    reports::ReportData data;
    if (!shard.is_whole()) store.set_shard(shard.text(), false);  // not before it ends
    const bool done = !any || run_with_progress(plan, store, data);
    if (!shard.is_whole() && done) store.set_shard(shard.text(), true);
    const auto count = [&](store::CellStatus status) {
        return std::ranges::count(data.stability, status, &store::CellRow::status);
    };
    const auto rows = std::ssize(data.stability), failed = count(store::CellStatus::failed),
               unavailable = count(store::CellStatus::unavailable);
    if (json) {
        const nlohmann::json line = {{"rows", rows},
                                     {"verified", rows - failed - unavailable},
                                     {"failed", failed},
                                     {"unavailable", unavailable},
                                     {"store", options.store}};
        print_json(line);
    } else {
        print(data);
        fmt::print(
            "{} rows: {} verified, {} failed, {} unavailable\nstore: {}; for the report: edgewise report {}\n",
            rows, rows - failed - unavailable, failed, unavailable, options.store, options.store);
    }
    const bool nothing = rows == unavailable && any;
    if (nothing) warn("nothing was compared: no row has an answer; each says why");
    return nothing || failed > 0 || !done ? exit_check_failed : exit_done;
}

}  // namespace

void add_stability(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "stability",
                    "Hard cases through every algorithm and table type, judged exactly", run_stability);
    add_families_option(*command, options.plan.families);
    add_layouts_option(*command, options.layouts);
    add_algorithms_option(*command, options.algorithms);
    add_shapes_option(*command, options.shapes, options.as_stored);
    add_count(*command, "--count", options.plan.count, input::cases_range, "poses per family");
    add_count(*command, "--proofs", options.plan.proofs, input::cases_or_none,
              "poses per family with depth, certificate and time, at most");
    add_seed_option(*command, options.plan.seed);
    add_shard_options(*command, options.shard, options.costs);
    add_store_option(*command, options.store, "filled or resumed")->capture_default_str();
}

}  // namespace edgewise::cli
