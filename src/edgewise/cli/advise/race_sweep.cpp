// SPDX-License-Identifier: MIT
#include "edgewise/cli/advise/race_sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "edgewise/scene/scenes.hpp"

namespace edgewise::cli {

namespace {

namespace fs = std::filesystem;
using studies::advise::CaseAsked;

std::string comma_list(const std::vector<std::string>& names) {
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
    const std::string shape = asked.mesh.empty() ? asked.shape.name : fs::absolute(asked.mesh).string();
    return folder.write(std::string(name) + ".json", {{"scene", scene.name},
                                                      {"shapes", {shape}},
                                                      {"needs", to_string(asked.needs)},
                                                      {"parameters", scene.parameters}});
}

}  // namespace

WorkFolder::WorkFolder() : path_(fs::temp_directory_path() / fmt::format("edgewise-advise-{}", getpid())) {
    fs::create_directories(path_);
}

WorkFolder::~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string WorkFolder::write(const std::string& name, const nlohmann::json& json) const {
    std::ofstream(file(name)) << json.dump();
    return file(name);
}

RaceSweep sweep_of(const std::vector<studies::advise::ScreenedCell>& cells) {
    std::set<std::string> tables, algorithms;
    for (const auto& cell : cells) {
        tables.insert(cell.type->name);
        algorithms.insert(cell.algorithm);
    }
    RaceSweep sweep;
    sweep.tables.assign(tables.begin(), tables.end());
    sweep.algorithms.assign(algorithms.begin(), algorithms.end());
    return sweep;
}

std::vector<std::string> command_of(const RaceSweep& sweep, const CaseAsked& asked, const WorkFolder& folder,
                                    double seconds) {
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
    option("--store", sweep.store);
    option("--layouts", comma_list(sweep.tables));
    option("--algorithms", comma_list(sweep.algorithms));
    option("--queries", std::to_string(sweep.queries));
    option("--checked", std::to_string(sweep.checked));
    option("--rounds", std::to_string(sweep.rounds));
    option("--seed", std::to_string(asked.seed));
    option("--probes", sweep.traces ? "time,error,bytes,lines,caches" : "time,error,bytes");
    if (sweep.traces) {
        option("--caches", "all");
        option("--machines", comma_list(sweep.machines));
    }
    if (asked.as_stored) command.emplace_back("--as-stored");
    option("--scenes", scene_file(case_scene, asked, scene_of(asked), folder));
    if (sweep.times_in_cache) command.push_back(scene_file(small_scene, asked, in_cache(asked), folder));
    return command;
}

}  // namespace edgewise::cli
