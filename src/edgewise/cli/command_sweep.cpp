// SPDX-License-Identifier: MIT
//
// `edgewise sweep`: runs a plan into a store and writes the report. Ctrl-C stops after the round in hand: the
// report is of what is there, and the next run goes on.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <map>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/cli/parts/sweep_parts.hpp"
#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/reports/page/report.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/sweep/stored_cells.hpp"
#include "edgewise/sweep/study.hpp"

namespace edgewise::cli {

namespace {

constexpr input::CountRange processes_range{1, 100, "processes"};

struct SweepArguments {
    std::string plan = "quick";
    std::string store;  ///< empty: the usual one
    std::string out, shard, costs;
    bool fom = false;
    std::vector<std::string> layouts, algorithms, peers, axes, scenes, shapes, caches, machines, probes;
    std::optional<std::size_t> queries, checked;
    std::optional<int> rounds, processes;
    int process = 1;
    std::optional<std::size_t> stability, effort;
    bool waits = false;
    bool each_mesh = false, as_stored = false, no_report = false;
    std::optional<std::uint64_t> seed;
    const CLI::App* command = nullptr;  ///< what was typed
};

/// The work of a sweep and how far it came, kept in the store while it runs: a report then knows one that
/// was stopped, and how many of its cells are missing.
class RunNote {
  public:
    /// `command`: as it would be typed again; `cells`: those of its plan.
    RunNote(store::Store& store, std::string command, std::size_t cells)
        : store_(store), command_(std::move(command)) {
        store_.set_meta(store::command_key + command_, bench::this_build().id);
        note_ = {{"build", bench::this_build().id},
                 {"cells", cells},
                 {"done", 0},
                 {"started", utc_time()},
                 {"ended", nullptr}};
        keep();
    }
    void add_done(std::size_t cells) {
        note_["done"] = note_["done"].get<std::size_t>() + cells;
        keep();
    }
    /// All of it is done, with what follows the cells.
    void end() {
        note_["ended"] = utc_time();
        keep();
    }

  private:
    /// Now, as "2026-01-31T23:59:59Z" (ISO 8601, UTC).
    static std::string utc_time() {
        return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    }
    void keep() { store_.set_meta(store::run_key + command_, note_.dump()); }

    store::Store& store_;
    std::string command_;
    nlohmann::json note_;
};

/// What was typed, except where results go; in the order of the help text.
std::vector<std::string> words_of(const CLI::App& command) {
    std::vector<std::string> words = {command.get_name()};
    for (const CLI::Option* option : command.get_options()) {
        const std::string name = option->get_name();
        if (option->count() == 0 || name == "--store" || name == "--out" || name == "--json" ||
            name == "--fom")
            continue;
        words.push_back(name);
        if (option->get_items_expected_max() == 0) continue;  // a flag
        const std::vector<std::string> values = option->results();
        words.insert(words.end(), values.begin(), values.end());
    }
    return words;
}

/// A sweep of chosen scenes or bodies is about those: no study unless asked for.
bool narrowed(const SweepArguments& options) { return !options.scenes.empty() || !options.shapes.empty(); }

/// What would be left unused in silence.
void refuse_unused(const SweepArguments& options) {
    if (options.each_mesh && std::ranges::none_of(options.shapes, scene::names_mesh_file))
        throw std::invalid_argument("--each-mesh is for mesh files: name some with --shape, or leave it out");
    if (std::ranges::none_of(options.scenes, scene::is_scene_file))
        scene::refuse_as_stored_without_mesh(options.as_stored, options.shapes);
    const bool some_caches = options.plan != "quick" || !options.caches.empty() || !narrowed(options);
    if (!options.machines.empty() && !some_caches)
        throw std::invalid_argument(
            "--machines models caches of the shapes that --caches names: add --caches all");
}

/// Of a scene that was asked for by name, what else was named on the command line counts, not what the plan
/// would restrict it to.
sweep::SceneChoice unrestricted(sweep::SceneChoice scene, const SweepArguments& options) {
    if (!options.layouts.empty()) scene.layouts.clear();
    if (!options.algorithms.empty()) scene.algorithms.clear();
    if (options.queries) scene.queries = 0;
    if (!options.axes.empty()) scene.plain = false;
    return scene;
}

/// Studies that only whole plans have: of scenes beside the sweep.
void narrow_studies(const SweepArguments& options, sweep::Plan& plan) {
    if (narrowed(options)) plan.studies.clear(), plan.processes = 1;
    if (options.stability) plan.studies["stability"] = *options.stability;
    if (options.effort) plan.studies["effort"] = *options.effort;
}

/// What a further process measures: times and their errors, of fewer checked answers. Its result is a median
/// without an interval of its own, so fewer rounds do.
void keep_to_times(sweep::Plan& plan) {
    constexpr std::size_t most_checked = 50;
    constexpr int most_rounds = 5;
    plan.rounds = std::min(plan.rounds, most_rounds);
    plan.checked = std::min(plan.checked, most_checked);
    plan.probes = {"time", "error"};
    plan.peers.clear();
    plan.studies.clear();
    for (sweep::SceneChoice& scene : plan.scenes) scene.caches.clear();
}

/// The scenes of the plan that were asked for by name, without default flags, and scenes that it does not
/// have.
std::vector<sweep::SceneChoice> chosen_scenes(const sweep::Plan& plan, const SweepArguments& options) {
    std::vector<sweep::SceneChoice> kept;
    for (const std::string& name : options.scenes) {
        const std::size_t before = kept.size();
        for (const sweep::SceneChoice& scene : plan.scenes) {
            if (scene.name != name) continue;
            kept.push_back(unrestricted(scene, options));
            std::erase(kept.back().axes, "build=default");
        }
        if (kept.size() == before) kept.push_back({name});
    }
    return kept;
}

/// Takes the bodies of the command line; optional recordings of the plan, which have their own, are left out.
void replace_bodies(const SweepArguments& options, sweep::Plan& plan) {
    take_bodies(options.shapes, plan);
    std::erase_if(plan.scenes, &sweep::SceneChoice::optional);
    for (sweep::SceneChoice& scene : plan.scenes) scene.shapes.clear();
    plan.bodies_for_files = true;
    plan.each_mesh = options.each_mesh;
}

/// The plan with the command line's filters over it. Naming shapes replaces the plan's bodies.
sweep::Plan chosen_plan(const SweepArguments& options) {
    sweep::Plan plan = sweep::make_plan(options.plan);
    const auto replace = [](auto& to, const auto& from) {
        if (!from.empty()) to = from;
    };
    replace(plan.layouts, options.layouts);
    for (sweep::SceneChoice& scene : plan.scenes) {
        if (scene::is_scene_file(scene.name)) replace(scene.layouts, options.layouts);
        if (!options.layouts.empty() || !options.algorithms.empty()) scene.pairs.clear();
    }
    replace(plan.algorithms, options.algorithms);
    replace(plan.peers, options.peers);
    replace(plan.axes, options.axes);
    if (!options.shapes.empty()) replace_bodies(options, plan);
    plan.as_stored = plan.as_stored || options.as_stored;
    if (!options.scenes.empty()) plan.scenes = chosen_scenes(plan, options);
    replace(plan.machines, options.machines);
    replace(plan.probes, options.probes);
    for (sweep::SceneChoice& scene : plan.scenes) replace(scene.caches, options.caches);
    plan.queries = options.queries.value_or(plan.queries);
    plan.checked = options.checked.value_or(plan.checked);
    plan.rounds = options.rounds.value_or(plan.rounds);
    narrow_studies(options, plan);
    plan.seed = options.seed.value_or(plan.seed);
    plan.processes = options.processes.value_or(plan.processes);
    plan.process = options.process;
    if (plan.process > 1) keep_to_times(plan);
    return plan;
}

/// Runs the further processes of the plan, each of this program with the same options. Returns false if one
/// of them was stopped or failed.
bool run_processes(const SweepArguments& options, const sweep::Plan& plan, const std::string& store) {
    for (int process = 2; process <= plan.processes; ++process) {
        fmt::print(stderr, "sweep: process {} of {} times the fastest cells again\n", process,
                   plan.processes);
        std::vector<std::string> command = words_of(*options.command);
        std::erase(command, "--no-report");
        command.insert(command.begin(), std::filesystem::read_symlink("/proc/self/exe").string());
        command.insert(command.end(),
                       {"--no-report", "--store", store, "--process", std::to_string(process)});
        const auto run = measure::run_program(command);
        if (run.value && run.value->exit_code == exit_done) continue;
        warn(fmt::format("process {} did not come to its end: {}", process,
                         run.value ? run.value->err : run.reason));
        return false;
    }
    return true;
}

/// `report`: of what was written of the store; its page is empty where nothing was.
void print_summary(const PartsSummary& outcome, const std::string& store,
                   const reports::ReportSummary& report, bool json) {
    const sweep::SweepSummary& summary = outcome.sweep;
    const std::string& page = report.page;
    if (json) {
        nlohmann::json line = {{"cells", summary.cells},   {"verified", summary.verified},
                               {"failed", summary.failed}, {"unavailable", summary.unavailable},
                               {"store", store},           {"report", or_null(page)}};
        if (summary.judged > 0) line["judged"] = summary.judged;
        for (const auto& [study, counts] : outcome.studies) {
            line[study + "_rows"] = counts.rows;
            line[study + "_failed"] = counts.failed;
        }
        print_json(line);
        return;
    }
    fmt::print("{} cells: {} verified, {} failed, {} unavailable\n", summary.cells, summary.verified,
               summary.failed, summary.unavailable);
    if (summary.judged > 0)
        fmt::print("{} cells of other libraries and of raw V-Clip judged\n", summary.judged);
    for (const auto& [study, counts] : outcome.studies)
        fmt::print("{} {} rows: {} failed, {} unavailable\n", counts.rows, study, counts.failed,
                   counts.unavailable);
    fmt::print("store: {}\n", store);
    if (!page.empty())
        fmt::print("report: {}\n\n{}\n\nopen {} in a browser\n", page, input::shown_text(report.answer),
                   page);
}

/// Beside each other: a part has a file of its own, wherever it runs.
std::string store_of(const SweepArguments& options, const sweep::Shard& shard) {
    if (!options.store.empty()) return options.store;
    return shard.is_whole() ? default_store
                            : fmt::format("{}/shards/{:05}-of-{:05}.db", folder_of(default_store),
                                          shard.index, shard.count);
}

/// A part has no report: that is the merged store's.
int finish_sweep(const SweepArguments& options, const PartsSummary& outcome, const sweep::Shard& shard,
                 const std::string& store, bool json) {
    reports::ReportSummary report;
    if (shard.is_whole() && !options.no_report) {
        const std::string out = options.out.empty() ? folder_of(store) : options.out;
        report = reports::write_report(store, out, bench::charts_folder());
        if (!report.note.empty()) warn(report.note);
    }
    print_summary(outcome, store, report, json);
    if (!shard.is_whole() && !json)
        fmt::print("a part of a campaign; all of them as one: edgewise merge STORES... --out ALL\n");
    if (options.fom) print_figures_of_merit(store);
    const sweep::SweepSummary& cells = outcome.sweep;
    const StudyCounts rows = outcome.all_studies();
    const bool nothing = cells.cells > 0 && cells.cells == cells.unavailable && rows.rows == rows.unavailable;
    if (nothing) warn("nothing was compared: no cell has an answer; the report says why");
    return nothing || cells.failed + rows.failed > 0 ? exit_check_failed : exit_done;
}

/// Checks the folders, or makes them. The folder of a part without --store is made for it.
void check_folders(const SweepArguments& options, const sweep::Shard& shard, const std::string& store,
                   bool makes) {
    if (shard.is_whole() || !options.store.empty())
        (makes ? make_folder_of : check_folder_of)(store, "--store");
    else if (makes)
        std::filesystem::create_directories(folder_of(store));
    if (!options.out.empty()) (makes ? make_folder : check_folder)(options.out, "--out");
}

int run_sweep(const SweepArguments& options, bool json) {
    refuse_unused(options);
    const sweep::Shard shard = chosen_shard(options.shard);
    const std::string path = store_of(options, shard);
    check_folders(options, shard, path, false);
    const auto seconds =
        options.costs.empty() ? std::map<std::string, double>() : sweep::seconds_in(options.costs);
    sweep::SweepWork work = sweep::prepare_sweep(chosen_plan(options), warn);
    sweep::keep_shard(work, shard, seconds);
    if (options.process > 1) sweep::keep_finalists(work, path);
    check_folders(options, shard, path, true);
    if (options.process == 1) say_how_quiet(options.waits, json);
    PartsSummary outcome;
    {
        store::Store store(path);
        if (!shard.is_whole()) store.set_shard(shard.text(), false);  // nor by an earlier run
        RunNote note(store, fmt::format("{}", fmt::join(words_of(*options.command), " ")), work.cells());
        outcome = run_parts(work, store, [&](std::size_t cells) { note.add_done(cells); });
        if (!outcome.stopped) {
            note.end();
            if (!shard.is_whole()) store.set_shard(shard.text(), true);
        }
    }
    if (outcome.stopped && (outcome.sweep.cells == 0 || !shard.is_whole())) {
        warn(fmt::format("stopped; what was measured is in {}, and the same command resumes there", path));
        return exit_check_failed;
    }
    if (!outcome.stopped && shard.is_whole() && options.process == 1)
        outcome.stopped = !run_processes(options, work.plan, path);
    const int code = finish_sweep(options, outcome, shard, path, json);
    if (!outcome.stopped) return code;
    warn(fmt::format("stopped: {} of {} cells are there; the same command goes on from them",
                     outcome.sweep.cells, work.cells()));
    return exit_check_failed;
}

void add_timing_options(CLI::App& command, SweepArguments& options) {
    add_rounds_option(command, options.rounds, input::rounds_range);
    add_count(command, "--processes", options.processes, processes_range,
              "processes that time the fastest cells, one after the other");
    add_count(command, "--process", options.process, processes_range,
              "which of them this one is: from 2 on it times the fastest cells of the store again; the sweep "
              "starts these itself");
    add_wait_option(command, options.waits);
}

}  // namespace

void add_sweep(CLI::App& app, Context& context) {
    auto [command, options] = add_command(
        app, context, "sweep", "Verifies and measures every cell of a plan, then reports", run_sweep);
    options.command = command;
    command->add_option("--plan", options.plan, "quick, paper, full, peers, recorded, or a JSON file")
        ->capture_default_str();
    add_store_option(*command, options.store, "filled or resumed")->default_str(default_store);
    command->add_option("--out", options.out, "folder to write: the report; the store's folder if not given");
    add_layouts_option(*command, options.layouts);
    add_algorithms_option(*command, options.algorithms);
    command->add_flag("--no-report", options.no_report, "fill the store and write no report")
        ->excludes(command->get_option("--out"));
    add_peers_option(*command, options.peers);
    add_names(*command, "--axes", options.axes,
              "these axes in addition to the plain cells, such as gap_tolerance=1e-06");
    add_names(*command, "--scenes", options.scenes,
              "only these scenes: kinds, scene files, or your own NAME.json");
    add_shapes_option(*command, options.shapes, options.as_stored);
    add_names(*command, "--caches", options.caches, "model caches for cells of these shapes, or all");
    add_machines_option(*command, options.machines);
    add_names(*command, "--probes", options.probes,
              "measure cells by these probes alone (edgewise list probes)");
    command->add_flag("--each-mesh", options.each_mesh,
                      "one body for each mesh of a file, not one for the file");
    add_queries_option(*command, options.queries);
    add_checked_option(*command, options.checked);
    add_timing_options(*command, options);
    add_count(*command, "--stability", options.stability, input::cases_or_none,
              "hard cases per family; 0: no stability run");
    add_count(*command, "--effort", options.effort, input::queries_or_none,
              "queries counted by Callgrind per cell; 0: none");
    add_shard_options(*command, options.shard, options.costs);
    command->add_flag("--fom", options.fom, "print figures of merit too: FOM name = value unit");
    add_seed_option(*command, options.seed);
}

}  // namespace edgewise::cli
