// SPDX-License-Identifier: MIT
#include "edgewise/cli/advise/advice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>
#include <thread>

#include "edgewise/cli/command.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/counters/calibration.hpp"
#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/scenes.hpp"

namespace edgewise::cli {

namespace {

using studies::advise::CaseAsked, studies::advise::RaceCost, studies::advise::RacePlan,
    studies::advise::ScreenedCell;
namespace fs = std::filesystem;

/// The scenes of such a sweep: the case, and few bodies that fit the cache.
constexpr const char *case_scene = "advise_case", *small_scene = "advise_in_cache";

/// New, and removed at the end with all that it holds.
class WorkFolder {
  public:
    WorkFolder() {
        std::string name = fs::temp_directory_path() / "edgewise-advise-XXXXXX";
        if (!mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), name);
        path_ = name;
    }
    ~WorkFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const nlohmann::json& json) const {
        std::ofstream(file(name)) << json.dump();
        return file(name);
    }

  private:
    fs::path path_;
};

/// What the sweep of a process asks and checks of every cell.
constexpr std::size_t swept_queries = 3000, swept_checked = 100;

/// A sweep is of every table type of the cells with every algorithm of theirs.
struct Swept {
    std::set<std::string> tables, algorithms;
};

Swept swept_for(const std::vector<ScreenedCell>& cells) {
    Swept swept;
    for (const ScreenedCell& cell : cells) {
        swept.tables.insert(cell.type->name);
        swept.algorithms.insert(cell.algorithm);
    }
    return swept;
}

template <class Names>
std::string comma_list(const Names& names) {
    return fmt::format("{}", fmt::join(names, ","));
}

/// Returns the scene with three bodies and one table, if it has such parameters.
sweep::SceneChoice in_cache(const CaseAsked& asked) {
    sweep::SceneChoice scene = asked.scene;
    const auto known = scene::complete_parameters(scene.name, {}).or_throw();
    if (known.contains("bodies")) scene.parameters["bodies"] = 3;
    if (known.contains("own_tables")) scene.parameters["own_tables"] = 0;
    return scene;
}

std::string scene_file(const char* name, const CaseAsked& asked, const sweep::SceneChoice& scene,
                       const WorkFolder& folder) {
    nlohmann::json file = {
        {"scene", scene.name}, {"needs", to_string(asked.needs)}, {"parameters", scene.parameters}};
    if (asked.recording.empty()) {
        file["shapes"] = {asked.mesh.empty() ? asked.shape.name : fs::absolute(asked.mesh).string()};
    } else {
        file["recording"] = asked.recording;
        file["parameters"].erase("recording");  // computed
    }
    return folder.write(std::string(name) + ".json", file);
}

/// Of the race's time, a process that models machines is planned to take one.
constexpr double parts_of_time = 8;

constexpr const char* no_time = "no time was left (--time)";

/// By what the first look took. A traced query takes about 60 times as long, and as long again for the
/// caches of each machine; processors share that.
RaceCost cost_of(const std::vector<ScreenedCell>& cells, std::size_t machines) {
    constexpr double traced_over_timed = 60, checks_over_first_look = 2;
    const auto [tables, algorithms] = swept_for(cells);
    const double swept =
        static_cast<double>(tables.size() * algorithms.size()) / static_cast<double>(cells.size());
    RaceCost cost;
    for (const ScreenedCell& cell : cells) {
        cost.process += swept * checks_over_first_look * cell.seconds;
        cost.round += swept * cell.ns * 1e-9 * static_cast<double>(swept_queries);
    }
    cost.traces = traced_over_timed * static_cast<double>(1 + std::max<std::size_t>(machines, 1)) *
                  cost.round / std::max(1U, std::thread::hardware_concurrency());
    return cost;
}

class Running {
  public:
    Running(const CaseAsked& asked, const std::vector<ScreenedCell>& cells, const RaceOptions& options)
        : asked_(asked), cells_(cells), named_(options.machines), seconds_(options.seconds) {}

    Race run() {
        std::string problem = named_.empty() ? "" : model_named_machines();
        RacePlan plan = studies::advise::race_within(seconds_left(), cost_of(cells_, named_.size()));
        plan.processes = std::min(plan.processes, studies::advise::whole_race.processes - race_.processes());
        const bool hosts_caches = std::ranges::find(named_, studies::advise::this_machine) == named_.end();
        for (int left = plan.processes; left > 0 && problem.empty(); --left) {
            rounds_ = plan.rounds;
            times_in_cache_ = left == plan.processes && asked_.recording.empty();
            machines_.clear();
            if (left == 1 && hosts_caches) machines_ = {studies::advise::this_machine};
            problem = run_process(seconds_left());
        }
        race_.problem = problem;
        rank();
        return std::move(race_);
    }

  private:
    [[nodiscard]] double seconds_left() const { return seconds_ - watch_.elapsed_ns() * 1e-9; }

    /// A process before all others. Fewer cells on the machines that were named are better than none: the
    /// slowest cells are left out until the process is expected to take a small part of the time, for
    /// others may keep the processors busy; where it takes too long all the same, it is begun again with the
    /// fastest and the baseline.
    std::string model_named_machines() {
        machines_ = named_;
        while (expected_seconds(studies::advise::least_race) > seconds_ / parts_of_time &&
               leave_out_slowest())
            continue;
        std::string problem = model_within(seconds_ / 2);
        if (problem.empty()) return problem;
        while (leave_out_slowest()) continue;
        return model_within(seconds_left());
    }

    std::string model_within(double seconds) {
        const bool has_time = expected_seconds(studies::advise::whole_race) < seconds_ / parts_of_time;
        rounds_ = (has_time ? studies::advise::whole_race : studies::advise::least_race).rounds;
        return run_process(seconds);
    }

    /// Expected seconds of one process that traces.
    [[nodiscard]] double expected_seconds(const RacePlan& plan) const {
        const RaceCost one = cost_of(cells_, named_.size());
        return one.process + plan.rounds * one.round + one.traces;
    }

    /// The fastest and the baseline stay; false where there is nothing else.
    bool leave_out_slowest() {
        const auto slowest = std::find_if(cells_.rbegin(), cells_.rend(), [&](const auto& cell) {
            return !cell.is_baseline() && &cell != &cells_.front();
        });
        if (slowest == cells_.rend()) return false;
        cells_.erase(std::prev(slowest.base()));
        return true;
    }

    /// Returns the command line of a process: a sweep of this program into that store, a store of its own, in
    /// a folder that goes with the race. It is ended after this number of seconds.
    [[nodiscard]] std::vector<std::string> command(const std::string& store, double seconds) const {
        // coreutils' timeout ends it when the time is over; Ctrl-C still ends both.
        std::vector<std::string> command = {"timeout",
                                            "--foreground",
                                            "--signal=KILL",
                                            fmt::format("{:.3f}", seconds),
                                            fs::read_symlink("/proc/self/exe").string(),
                                            "sweep",
                                            "--no-report"};
        const auto option = [&](const char* name, const std::string& value) {
            command.insert(command.end(), {name, value});
        };
        const auto [tables, algorithms] = swept_for(cells_);
        const bool traces = !machines_.empty();
        option("--store", store);
        option("--layouts", comma_list(tables));
        option("--algorithms", comma_list(algorithms));
        option("--queries", std::to_string(swept_queries));
        option("--checked", std::to_string(swept_checked));
        option("--rounds", std::to_string(rounds_));
        option("--seed", std::to_string(asked_.seed));
        option("--probes", traces ? "time,error,bytes,memory,lines,caches" : "time,error,bytes,memory");
        if (traces) {
            option("--caches", "all");
            option("--machines", comma_list(machines_));
        }
        if (asked_.as_stored) command.emplace_back("--as-stored");
        option("--scenes", scene_file(case_scene, asked_, scene_of(asked_), folder_));
        if (times_in_cache_) command.push_back(scene_file(small_scene, asked_, in_cache(asked_), folder_));
        return command;
    }

    /// Empty, or why it did not come to its end.
    std::string run_process(double seconds) {
        if (stop_requested) return "stopped";
        if (seconds <= 0) return no_time;
        const std::string store = folder_.file(std::to_string(++begun_) + ".db");
        const measure::Stopwatch watch;
        const auto run = measure::run_program(command(store, seconds));
        if (!run.value) return run.reason;
        if (run.value->exit_code != 0) return watch.elapsed_ns() * 1e-9 >= seconds ? no_time : run.value->err;
        race_.stores.push_back(reports::read_report(store));
        take_caches(race_.stores.back());
        return "";
    }

    /// The cells of the case, of all processes.
    void rank() {
        std::vector<const reports::ReportCell*> cells;
        for (const reports::ReportData& store : race_.stores)
            for (const reports::ReportCell* cell : store.swept())
                if (cell->scene == case_scene) cells.push_back(cell);
        race_.answer.question.error_limit = asked_.error_limit;
        if (cells.empty()) return;
        race_.answer.baseline = reports::baseline_of(race_.stores.front());
        reports::SceneRanking scene = reports::rank_scene(cells, asked_.error_limit, race_.answer.baseline);
        if (scene.cells.empty()) return;
        scene.label = asked_.scene.name;
        race_.answer.shape = scene.shape, race_.answer.vertices = scene.vertices;
        (scene.own_tables ? race_.answer.own : race_.answer.shared).push_back(std::move(scene));
    }

    void take_caches(const reports::ReportData& store) {
        for (const reports::ReportCell* cell : store.swept()) {
            const auto measured = reports::ranked_cell(*cell, asked_.error_limit);
            if (!measured) continue;
            studies::advise::CacheCost& one = race_.caches[measured->name()];
            if (cell->scene == small_scene) one.in_cache_ns = measured->ns;
            if (cell->scene == case_scene) take_misses(*cell, one);
        }
    }

    /// Misses on the asked machines and on this one; a machine with unknown caches has none.
    void take_misses(const reports::ReportCell& cell, studies::advise::CacheCost& one) const {
        for (const measure::MachineChoice& choice : measure::choose_machines(machines_)) {
            if (!choice.machine.value) continue;
            constexpr store::FigureName misses("caches.{machine}.{level}.misses_per_query");
            std::vector<double> levels;
            for (const measure::LevelGeometry& level : choice.machine.value->caches.levels)
                if (const auto value = cell.figure(misses.of(choice.name, level.name)).value)
                    levels.push_back(*value);
            if (!levels.empty() && levels.size() == choice.machine.value->caches.levels.size())
                one.misses[choice.name] = levels;
        }
    }

    const CaseAsked& asked_;
    std::vector<ScreenedCell> cells_;
    std::vector<std::string> named_;  ///< machines
    double seconds_;
    std::vector<std::string> machines_;  ///< of the process in hand, to model the caches of; none: no traces
    int rounds_ = 0;                     ///< likewise
    bool times_in_cache_ = false;        ///< likewise, in addition to timing the case
    WorkFolder folder_;
    measure::Stopwatch watch_;
    Race race_;
    int begun_ = 0;  ///< processes
};

}  // namespace

const reports::SceneRanking* Race::scene() const {
    const auto scenes = answer.scenes();
    return scenes.empty() ? nullptr : scenes.front();
}

const reports::RankedCell* Race::taken() const {
    const auto take = reports::recommendation_of(answer.shared.empty() ? answer.own : answer.shared);
    return take ? take->example().cell : scene() ? scene()->choice() : nullptr;
}

const studies::advise::CacheCost* Race::caches_of(const reports::RankedCell& cell) const {
    const auto found = caches.find(cell.name());
    return found == caches.end() ? nullptr : &found->second;
}

const reports::RankedCell* Race::fastest_predicted(const std::string& machine) const {
    if (!scene()) return nullptr;
    const reports::RankedCell* fastest = nullptr;
    double least = 0;
    for (const reports::RankedCell& one : scene()->cells) {
        const studies::advise::CacheCost* const cost = caches_of(one);
        if (!one.meets_error() || !cost || !cost->predicted_ns.contains(machine)) continue;
        const double ns = cost->predicted_ns.at(machine);
        if (!fastest || ns < least) fastest = &one, least = ns;
    }
    return fastest;
}

std::optional<bool> Race::prediction_held() const {
    const reports::RankedCell* const fastest = fastest_predicted(studies::advise::this_machine);
    return fastest ? std::optional(scene()->ties_with_winner(*fastest)) : std::nullopt;
}

Race run_race(const CaseAsked& asked, const std::vector<ScreenedCell>& cells, const RaceOptions& options) {
    Race race = Running(asked, cells, options).run();
    if (const auto host = measure::host_machine(); host.value && race.processes() > 0) {
        race.latencies_ns = measure::latencies_beyond_first(*host.value);
        for (auto& [name, cost] : race.caches) studies::advise::predict(cost, race.latencies_ns);
    }
    return race;
}

}  // namespace edgewise::cli
