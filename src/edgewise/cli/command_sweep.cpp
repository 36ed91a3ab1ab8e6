// SPDX-License-Identifier: MIT
//
// `edgewise sweep`: runs a plan into a store and writes the report. Ctrl-C stops after the round in hand; the
// next run goes on from there.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/reports/page/report.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/studies/effort_rows.hpp"
#include "edgewise/studies/fields/fields_rows.hpp"
#include "edgewise/studies/paging_rows.hpp"
#include "edgewise/studies/thrash/thrash_rows.hpp"
#include "edgewise/sweep/run.hpp"

namespace edgewise::cli {

namespace {

struct SweepArguments {
    std::string plan = "quick";
    std::string store = default_store;
    std::string out;
    std::vector<std::string> layouts, algorithms, peers, axes, scenes, shapes, meshes, caches, machines;
    std::optional<std::size_t> queries, checked;
    std::optional<int> rounds;
    std::optional<std::size_t> stability, effort;
    bool each_mesh = false;
    std::optional<std::uint64_t> seed;
    const CLI::App* command = nullptr;  ///< what was typed
};

/// "sweep --plan paper --rounds 5": what was typed, but for where things go; in the order of the help text.
std::string command_line(const CLI::App& command) {
    std::string line = command.get_name();
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || name == "--store" || name == "--out" || name == "--json") continue;
        line += " " + name;
        if (option->get_items_expected_max() == 0) continue;  // a flag
        for (const std::string& value : option->results()) line += " " + value;
    }
    return line;
}

/// A sweep of chosen scenes or bodies is about those: no stability run unless asked for.
bool narrowed(const SweepArguments& options) {
    return !options.scenes.empty() || !options.shapes.empty() || !options.meshes.empty();
}

/// Of a scene that was asked for by name, what else was named on the command line counts, not what the plan
/// would restrict it to.
sweep::SceneChoice unrestricted(sweep::SceneChoice scene, const SweepArguments& options) {
    if (!options.shapes.empty() || !options.meshes.empty()) scene.shapes.clear();
    if (!options.layouts.empty()) scene.layouts.clear();
    if (!options.algorithms.empty()) scene.algorithms.clear();
    if (options.queries) scene.queries = 0;
    if (!options.axes.empty()) scene.plain = false;
    return scene;
}

/// Runs that only whole plans have: of scenes beside the sweep.
void narrow_runs(const SweepArguments& options, sweep::Plan& plan) {
    plan.stability = options.stability.value_or(narrowed(options) ? 0 : plan.stability);
    if (narrowed(options)) {
        plan.paging = 0;
        plan.thrash = false;
    }
    plan.effort = options.effort.value_or(narrowed(options) ? 0 : plan.effort);
    if (narrowed(options)) plan.fields = 0;
}

/// The plan with the command line's filters over it. Naming shapes or meshes replaces the plan's bodies.
sweep::Plan chosen_plan(const SweepArguments& options) {
    sweep::Plan plan = sweep::make_plan(options.plan);
    const auto replace = [](auto& to, const auto& from) {
        if (!from.empty()) to = from;
    };
    replace(plan.layouts, options.layouts);
    for (sweep::SceneChoice& scene : plan.scenes) {
        if (scene::find_scene_file(scene.name)) replace(scene.layouts, options.layouts);
    }
    replace(plan.algorithms, options.algorithms);
    replace(plan.peers, options.peers);
    replace(plan.axes, options.axes);
    if (!options.shapes.empty() || !options.meshes.empty()) {
        plan.shapes = options.shapes;
        plan.meshes = options.meshes;
        plan.meshes_required = true;
        plan.each_mesh = options.each_mesh;
    }
    if (!options.scenes.empty()) {
        std::vector<sweep::SceneChoice> kept;
        for (const std::string& name : options.scenes) {
            const std::size_t before = kept.size();
            for (const sweep::SceneChoice& scene : plan.scenes) {
                if (scene.name == name) kept.push_back(unrestricted(scene, options));
            }
            if (kept.size() == before) kept.push_back({name});
        }
        plan.scenes = kept;
    }
    replace(plan.machines, options.machines);
    for (sweep::SceneChoice& scene : plan.scenes) replace(scene.caches, options.caches);
    plan.queries = options.queries.value_or(plan.queries);
    plan.checked = options.checked.value_or(plan.checked);
    plan.rounds = options.rounds.value_or(plan.rounds);
    narrow_runs(options, plan);
    plan.seed = options.seed.value_or(plan.seed);
    return plan;
}

sweep::SweepSummary run_with_progress(const sweep::SweepWork& work, store::Store& store) {
    std::unique_ptr<Progress> progress;
    sweep::SweepListener listener;
    listener.on_start = [&](std::size_t cells) { progress = std::make_unique<Progress>("sweep", cells); };
    listener.on_done = [&](std::size_t cells, const std::string& what) { progress->advance(cells, what); };
    listener.on_warning = [&](const std::string& line) {
        if (progress) progress->clear();
        warn(line);
    };
    return sweep::run_sweep(work, store, listener, stop_on_signals());
}

/// The hard families, if the plan has them, over the sweep's table types and algorithms.
studies::StabilitySummary run_stability_of(const sweep::SweepWork& work, store::Store& store) {
    if (work.plan.stability == 0) return {};
    studies::StabilityPlan plan;
    plan.count = plan.proofs = work.plan.stability;
    plan.seed = work.plan.seed;
    plan.raw = work.plan.control;
    plan.types = work.types;
    plan.algorithms = work.algorithms;
    for (const scene::NamedShape& shape : work.shapes) {
        if (shape.error.empty() && shape.source != "built-in") plan.real.push_back(shape.body);
    }
    return store_stability(plan, store, {});
}

/// Under memory limits, if the plan has it.
void run_paging_of(const sweep::Plan& of, store::Store& store, bool& stopped) {
    if (of.paging == 0) return;
    studies::PagingPlan plan;
    plan.bodies = of.paging;
    plan.seed = of.seed;
    Progress progress("paging", studies::paging_rows());
    stopped = !studies::run_paging(
        plan, bench::this_build().id, store,
        [&](const store::CellRow& row) { progress.advance(1, row.shape + " " + row.table); },
        stop_on_signals());
}

/// What could have made figure 8, if the plan asks and this program has the table types.
void run_thrash_of(const sweep::Plan& of, store::Store& store, bool& stopped) {
    studies::thrash::Levels levels;
    levels.seed = of.seed;
    if (!of.thrash || !studies::thrash::has_tables(levels)) return;
    Progress progress("thrash", studies::thrash::thrash_units(levels));
    stopped = !studies::thrash::run_thrash(
        levels, bench::this_build().id, store, [&] { progress.advance(1, "figure 8"); }, stop_on_signals());
}

/// What the queries take, of the sweep's table types, algorithms and peers, if the plan has it.
void run_effort_of(const sweep::SweepWork& work, store::Store& store, bool& stopped) {
    if (work.plan.effort == 0) return;
    const std::string machines[] = {studies::effort_machine};
    studies::EffortPlan plan{studies::effort_cell, work.types, work.peers, work.algorithms,
                             measure::choose_machines(machines).front()};
    plan.cell.queries = work.plan.effort;
    plan.cell.checked = std::min(work.plan.checked, work.plan.effort);
    plan.cell.seed = work.plan.seed;
    Progress progress("effort", studies::effort_rows(plan));
    stopped = !studies::store_effort(
        plan, bench::this_build().id, store,
        [&](std::size_t, const studies::EffortRow& row) {
            progress.advance(1, row.cell.algorithm + " " + row.cell.table);
        },
        stop_on_signals());
}

/// Which fields travel together, if the plan asks, of tables that this program can build otherwise.
void run_fields_of(const sweep::Plan& of, store::Store& store, bool& stopped) {
    if (of.fields == 0) return;
    const auto cells = studies::fields_cells(of.fields, of.seed);
    Progress progress("fields", cells.size());
    stopped = !studies::store_fields(
        cells, bench::this_build().id, store,
        [&](const store::CellRow& row) { progress.advance(1, row.algorithm + " " + row.table); },
        stop_on_signals());
}

void print_summary(const sweep::SweepSummary& summary, const studies::StabilitySummary& stability,
                   const std::string& store, const std::string& page, bool json) {
    if (json) {
        nlohmann::json line = {{"cells", summary.cells},   {"verified", summary.verified},
                               {"failed", summary.failed}, {"unavailable", summary.unavailable},
                               {"store", store},           {"report", page}};
        if (summary.judged > 0) line["judged"] = summary.judged;
        if (stability.rows > 0) {
            line["stability_rows"] = stability.rows;
            line["stability_failed"] = stability.failed;
        }
        fmt::print("{}\n", line.dump());
        return;
    }
    fmt::print("{} cells: {} verified, {} failed, {} unavailable\n", summary.cells, summary.verified,
               summary.failed, summary.unavailable);
    if (summary.judged > 0)
        fmt::print("{} cells of other libraries and of raw V-Clip judged\n", summary.judged);
    if (stability.rows > 0) {
        fmt::print("{} stability rows: {} failed, {} unavailable\n", stability.rows, stability.failed,
                   stability.unavailable);
    }
    fmt::print("store: {}\nreport: {}\n", store, page);
}

int run_sweep(const SweepArguments& options, bool json) {
    const sweep::SweepWork work = sweep::prepare_sweep(chosen_plan(options), warn);
    std::filesystem::create_directories(folder_of(options.store));
    sweep::SweepSummary summary;
    studies::StabilitySummary stability;
    {
        store::Store store(options.store);
        store.set_meta(store::command_key + command_line(*options.command), bench::this_build().id);
        summary = run_with_progress(work, store);
        if (!summary.stopped) stability = run_stability_of(work, store);
        summary.stopped = summary.stopped || stability.stopped;
        if (!summary.stopped) run_paging_of(work.plan, store, summary.stopped);
        if (!summary.stopped) run_thrash_of(work.plan, store, summary.stopped);
        if (!summary.stopped) run_effort_of(work, store, summary.stopped);
        if (!summary.stopped) run_fields_of(work.plan, store, summary.stopped);
    }
    if (summary.stopped) {
        warn(fmt::format("stopped; what was measured is in {}, and the same command resumes there",
                         options.store));
        return exit_check_failed;
    }
    const std::string out = options.out.empty() ? folder_of(options.store) : options.out;
    const reports::ReportSummary report = reports::write_report(options.store, out, bench::charts_folder());
    if (!report.note.empty()) warn(report.note);
    print_summary(summary, stability, options.store, report.page, json);
    return summary.failed + stability.failed > 0 ? exit_check_failed : exit_done;
}

}  // namespace

void add_sweep(CLI::App& app, Context& context) {
    const CLI::Range at_least_one(1, 1'000'000'000);
    auto [command, options] = add_command(
        app, context, "sweep", "Verifies and measures every cell of a plan, then reports", run_sweep);
    options.command = command;
    command->add_option("--plan", options.plan, "quick, paper, full, peers, or a JSON file")
        ->capture_default_str();
    command->add_option("--store", options.store, "SQLite file to fill or to resume")->capture_default_str();
    command->add_option("--out", options.out, "folder for the report; beside the store if not given");
    add_names(*command, "--layouts", options.layouts, "only these layouts or table types");
    add_names(*command, "--algorithms", options.algorithms, "only these algorithms");
    add_names(*command, "--peers", options.peers, "these libraries beside them, or all that are built");
    add_names(*command, "--axes", options.axes,
              "these axes beside the plain cells, such as gap_tolerance=1e-06");
    add_names(*command, "--scenes", options.scenes,
              "only these scenes: kinds, scene files, or your own NAME.json");
    add_names(*command, "--shapes", options.shapes, "these built-in shapes instead of the plan's bodies");
    add_names(*command, "--caches", options.caches, "model caches for cells of these shapes, or all");
    add_names(*command, "--machines", options.machines, "whose caches: names, host, or your own NAME.json");
    command->add_option("--mesh", options.meshes, "these mesh files instead of the plan's bodies");
    command->add_flag("--each-mesh", options.each_mesh,
                      "one body for each mesh of a file, not one for the file");
    command->add_option("--queries", options.queries, "queries per cell and round")->check(at_least_one);
    command->add_option("--checked", options.checked, "queries checked exactly per cell")
        ->check(at_least_one);
    command->add_option("--rounds", options.rounds, "timed rounds per cell")->check(at_least_one);
    command->add_option("--stability", options.stability, "hard cases per family; 0: no stability run");
    command->add_option("--effort", options.effort, "queries counted by Callgrind per cell; 0: none");
    command->add_option("--seed", options.seed, "seed of scenes and orders");
}

}  // namespace edgewise::cli
