// SPDX-License-Identifier: MIT
//
// `edgewise sweep`: runs a plan into a store and writes the report. Ctrl-C stops after the round in hand: the
// report is of what is there, and the next run goes on.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/utc_time.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/sweep_parts.hpp"
#include "edgewise/cli/usage/folders.hpp"
#include "edgewise/reports/page/report.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::cli {

namespace {

struct SweepArguments {
    std::string plan = "quick";
    std::string store = default_store;
    std::string out;
    std::vector<std::string> layouts, algorithms, peers, axes, scenes, shapes, meshes, caches, machines,
        probes;
    std::optional<std::size_t> queries, checked;
    std::optional<int> rounds;
    std::optional<std::size_t> stability, effort;
    bool each_mesh = false, no_report = false;
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

/// What would be left unused in silence.
void refuse_unused(const SweepArguments& options) {
    if (options.each_mesh && options.meshes.empty())
        throw std::invalid_argument("--each-mesh is of --mesh: name mesh files, or leave it out");
    const bool some_caches = options.plan != "quick" || !options.caches.empty() || !narrowed(options);
    if (!options.machines.empty() && !some_caches)
        throw std::invalid_argument(
            "--machines models caches of the shapes that --caches names: add --caches all");
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
}

/// The plan with the command line's filters over it. Naming shapes or meshes replaces the plan's bodies.
sweep::Plan chosen_plan(const SweepArguments& options) {
    sweep::Plan plan = sweep::make_plan(options.plan);
    const auto replace = [](auto& to, const auto& from) {
        if (!from.empty()) to = from;
    };
    replace(plan.layouts, options.layouts);
    for (sweep::SceneChoice& scene : plan.scenes) {
        if (scene::is_scene_file(scene.name)) replace(scene.layouts, options.layouts);
    }
    replace(plan.algorithms, options.algorithms);
    replace(plan.peers, options.peers);
    replace(plan.axes, options.axes);
    if (!options.shapes.empty() || !options.meshes.empty()) {
        plan.shapes = options.shapes;
        plan.meshes = options.meshes;
        plan.meshes_required = plan.bodies_for_files = true;
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
    replace(plan.probes, options.probes);
    for (sweep::SceneChoice& scene : plan.scenes) replace(scene.caches, options.caches);
    plan.queries = options.queries.value_or(plan.queries);
    plan.checked = options.checked.value_or(plan.checked);
    plan.rounds = options.rounds.value_or(plan.rounds);
    narrow_runs(options, plan);
    plan.seed = options.seed.value_or(plan.seed);
    return plan;
}

/// What the sweep is to do and when it began, into the store; again with its end once all of it is done.
void note_run(store::Store& store, const std::string& command, const nlohmann::json& run) {
    store.set_meta(store::run_key + command, run.dump());
}

void print_summary(const sweep::SweepSummary& summary, const studies::StabilitySummary& stability,
                   const std::string& store, const reports::ReportSummary& report, bool json) {
    const std::string& page = report.page;
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
    fmt::print("store: {}\nreport: {}\n\n{}\n\nopen {} in a browser\n", store, page, report.answer, page);
}

int run_sweep(const SweepArguments& options, bool json) {
    refuse_unused(options);
    check_folder_of_store(options.store);
    if (!options.out.empty()) check_folder(options.out, "--out");
    const sweep::SweepWork work = sweep::prepare_sweep(chosen_plan(options), warn);
    make_folder_of_store(options.store);
    if (!options.out.empty()) make_folder(options.out, "--out");
    PartsSummary parts;
    {
        store::Store store(options.store);
        const std::string command = command_line(*options.command);
        store.set_meta(store::command_key + command, bench::this_build().id);
        nlohmann::json run = {{"build", bench::this_build().id},
                              {"cells", work.cells()},
                              {"started", bench::utc_time()},
                              {"ended", nullptr}};
        note_run(store, command, run);
        parts = run_parts(work, store);
        if (!parts.stopped) run["ended"] = bench::utc_time(), note_run(store, command, run);
    }
    const bool right = !parts.stopped && parts.sweep.failed + parts.stability.failed == 0;
    if (parts.stopped && parts.sweep.cells == 0) {
        warn(
            "stopped before the first cells were done; the same command goes on from the rounds that are stored");
        return exit_check_failed;
    }
    if (options.no_report) return right ? exit_done : exit_check_failed;
    const std::string out = options.out.empty() ? folder_of(options.store) : options.out;
    const reports::ReportSummary report = reports::write_report(options.store, out, bench::charts_folder());
    if (!report.note.empty()) warn(report.note);
    print_summary(parts.sweep, parts.stability, options.store, report, json);
    if (parts.stopped)
        warn(fmt::format("stopped: {} of {} cells are there; the same command goes on from them",
                         parts.sweep.cells, work.cells()));
    return right ? exit_done : exit_check_failed;
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
    command->add_flag("--no-report", options.no_report, "fill the store and write no report")
        ->excludes(command->get_option("--out"));
    add_names(*command, "--peers", options.peers, "these libraries beside them, or all that are built");
    add_names(*command, "--axes", options.axes,
              "these axes beside the plain cells, such as gap_tolerance=1e-06");
    add_names(*command, "--scenes", options.scenes,
              "only these scenes: kinds, scene files, or your own NAME.json");
    add_names(*command, "--shapes", options.shapes, "these built-in shapes instead of the plan's bodies");
    add_names(*command, "--caches", options.caches, "model caches for cells of these shapes, or all");
    add_names(*command, "--machines", options.machines, "whose caches: names, host, or your own NAME.json");
    add_names(*command, "--probes", options.probes,
              "measure cells by these probes alone (edgewise list probes)");
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
