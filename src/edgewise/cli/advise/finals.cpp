// SPDX-License-Identifier: MIT
#include "edgewise/cli/advise/finals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/reports/answer/candidate.hpp"
#include "edgewise/studies/advise/level_latency.hpp"

namespace edgewise::cli {

namespace {

namespace fs = std::filesystem;
using studies::advise::CaseAsked;

constexpr const char *case_scene = "advise_case", *small_scene = "advise_in_cache";

/// Removed at the end with all that it holds.
class WorkFolder {
  public:
    WorkFolder() : path_(fs::temp_directory_path() / fmt::format("edgewise-advise-{}", getpid())) {
        fs::create_directories(path_);
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

nlohmann::json scene_json(const CaseAsked& asked, const sweep::SceneChoice& scene) {
    const std::string shape = asked.mesh.empty() ? asked.shape.name : fs::absolute(asked.mesh).string();
    return {{"scene", scene.name},
            {"shapes", {shape}},
            {"needs", to_string(asked.needs)},
            {"parameters", scene.parameters}};
}

/// The same motion of three bodies with one table, which fits every cache.
sweep::SceneChoice in_cache(const CaseAsked& asked) {
    const auto turn = asked.scene.parameters.find("rotation_step");
    return studies::advise::tumbling(3, turn == asked.scene.parameters.end() ? 0.1 : turn->second);
}

std::vector<std::string> sweep_command(const CaseAsked& asked,
                                       const std::vector<studies::advise::ScreenedCell>& finalists,
                                       const FinalsOptions& options, const WorkFolder& folder, int process) {
    std::set<std::string> tables = {"aos_f64"}, algorithms = {"vclip"};
    for (const auto& cell : finalists) {
        tables.insert(cell.type->name);
        algorithms.insert(cell.algorithm);
    }
    std::vector<std::string> command = {
        fs::read_symlink("/proc/self/exe").string(),
        "sweep",
        "--no-report",
        "--store",
        folder.file(fmt::format("{}.db", process)),
        "--layouts",
        fmt::format("{}", fmt::join(tables, ",")),
        "--algorithms",
        fmt::format("{}", fmt::join(algorithms, ",")),
        "--queries",
        std::to_string(options.queries),
        "--checked",
        "100",
        "--rounds",
        std::to_string(options.rounds),
        "--probes",
        process > 0 ? "time" : "time,error,bytes,memory,lines,caches",
        "--seed",
        std::to_string(asked.seed),
        "--scenes",
        folder.write(std::string(case_scene) + ".json", scene_json(asked, scene_of(asked)))};
    if (process > 0) return command;
    command.push_back(folder.write(std::string(small_scene) + ".json", scene_json(asked, in_cache(asked))));
    std::vector<std::string> machines = options.machines;
    if (std::ranges::find(machines, "host") == machines.end()) machines.emplace_back("host");
    command.insert(command.end(),
                   {"--caches", "all", "--machines", fmt::format("{}", fmt::join(machines, ","))});
    return command;
}

double value_of(const reports::ReportCell& cell, const store::FigureName& name) {
    return cell.figure(name).value.value_or(0);
}

/// Of the asked machines and of this one.
void add_misses(const reports::ReportCell& cell, const std::vector<std::string>& machines,
                Finalist& finalist) {
    for (const measure::MachineChoice& choice : measure::choose_machines(machines)) {
        if (!choice.machine.value) continue;
        constexpr store::FigureName misses("caches.{machine}.{level}.misses_per_query");
        for (const measure::LevelGeometry& level : choice.machine.value->caches.levels)
            finalist.misses[choice.name].push_back(value_of(cell, misses.of(choice.name, level.name)));
    }
}

/// What a process measured of the case, added to what is known.
void take_cells(const reports::ReportData& data, const FinalsOptions& options, int process, Finals& finals) {
    std::vector<std::string> machines = options.machines;
    machines.emplace_back("host");
    for (const reports::ReportCell* cell : data.swept()) {
        const auto candidate = reports::candidate_of(*cell, 1);
        if (!candidate) continue;
        auto found = std::ranges::find_if(finals.ranked, [&](const Finalist& known) {
            return known.algorithm == cell->algorithm && known.table == candidate->table;
        });
        if (found == finals.ranked.end()) {
            found = finals.ranked.emplace(finals.ranked.end());
            found->algorithm = cell->algorithm;
            found->table = candidate->table;
        }
        if (cell->scene == small_scene) found->in_cache_ns = candidate->ns;
        if (cell->scene != case_scene) continue;
        found->ratios.push_back(candidate->ratio);
        found->ns = candidate->ns;
        if (process > 0) continue;
        found->bytes_per_edge = candidate->bytes_per_edge.value_or(0);
        found->table_bytes = candidate->table_bytes.value_or(0);
        found->error = candidate->worst_error.value_or(0);
        found->steps = candidate->steps.value_or(0);
        found->lines = candidate->lines_per_query.value_or(0);
        add_misses(*cell, machines, *found);
    }
}

/// Ratios were to the baseline's algorithm in its plain question; from here on they are to its own cell,
/// which answers the same question as the others.
void set_noise(Finals& finals) {
    const Finalist* baseline = finals.find("vclip", "aos_f64");
    if (!baseline || baseline->ratios.empty()) return;
    const double mid = baseline->mid();
    finals.noise_low = baseline->low() / mid;
    finals.noise_high = baseline->high() / mid;
    for (Finalist& finalist : finals.ranked)
        for (double& ratio : finalist.ratios) ratio /= mid;
}

/// In-cache time, and each miss as long as the level takes here that answers it; nothing overlaps.
void predict(Finals& finals) {
    const auto host = measure::host_machine();
    if (!host.value) return;
    finals.latencies_ns = studies::advise::latencies_beyond_first(*host.value);
    for (Finalist& finalist : finals.ranked) {
        const auto misses = finalist.misses.find("host");
        if (misses == finalist.misses.end() || finalist.in_cache_ns == 0) continue;
        finalist.predicted_ns = finalist.in_cache_ns;
        for (std::size_t level = 0; level < misses->second.size(); ++level) {
            const double deeper = level + 1 < misses->second.size() ? misses->second[level + 1] : 0;
            finalist.predicted_ns += (misses->second[level] - deeper) * finals.latencies_ns[level];
        }
    }
}

}  // namespace

double Finalist::low() const { return *std::ranges::min_element(ratios); }
double Finalist::high() const { return *std::ranges::max_element(ratios); }
double Finalist::mid() const {
    std::vector<double> sorted = ratios;
    std::ranges::sort(sorted);
    return sorted[sorted.size() / 2];
}
std::string Finalist::name() const { return reports::algorithm_title(algorithm) + " on " + table; }

const Finalist* Finals::find(const std::string& algorithm, const std::string& table) const {
    const auto found = std::ranges::find_if(
        ranked, [&](const Finalist& one) { return one.algorithm == algorithm && one.table == table; });
    return found == ranked.end() ? nullptr : &*found;
}

bool Finals::ties(const Finalist& one) const { return one.low() <= ranked.front().high(); }

const Finalist& Finals::fastest_predicted() const {
    return *std::ranges::min_element(
        ranked, {}, [](const Finalist& one) { return one.predicted_ns > 0 ? one.predicted_ns : 1e300; });
}

Finals run_finals(const CaseAsked& asked, const std::vector<studies::advise::ScreenedCell>& finalists,
                  const FinalsOptions& options, const std::function<bool()>& stop) {
    Finals finals;
    const WorkFolder folder;
    for (int process = 0; process < options.processes && (process == 0 || !stop()); ++process) {
        const auto run = measure::run_program(sweep_command(asked, finalists, options, folder, process));
        if (!run.value || run.value->exit_code != 0) {
            finals.problem = run.value ? run.value->err : run.reason;
            if (process == 0) return finals;
            break;
        }
        take_cells(reports::read_report(folder.file(fmt::format("{}.db", process))), options, process,
                   finals);
        ++finals.processes;
    }
    finals.problem.clear();
    std::erase_if(finals.ranked, [](const Finalist& one) { return one.ratios.empty(); });
    set_noise(finals);
    predict(finals);
    std::ranges::stable_sort(finals.ranked, {}, &Finalist::mid);
    return finals;
}

}  // namespace edgewise::cli
