// SPDX-License-Identifier: MIT
#include "edgewise/sweep/stored_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/input/count.hpp"
#include "edgewise/store/merge.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::sweep {

namespace {

/// An earlier run may not have modelled these machines, or fewer queries.
bool lacks_caches(const CellRun& cell, const store::StoredCell& stored) {
    return !cell.caches().machines.empty() &&
           stored.figure("caches.identity").value != cell.caches().identity();
}

}  // namespace

std::optional<store::CellStatus> StoredCells::status_of(const CellRun& cell) const {
    const auto stored = store_.find_cell(build_, cell.row().hash);
    if (!stored) return std::nullopt;
    if (!stored->is_timed()) return stored->status;
    if (!rounds_missing(cell).empty()) return std::nullopt;
    if (lacks_checks(*stored)) return std::nullopt;
    if (stored->verified() && (lacks_caches(cell, *stored) || lacks_probes(*stored))) return std::nullopt;
    return stored->status;
}

std::string run_of(const Plan& plan) {
    return plan.process == 1 ? store::sweep_run : fmt::format("{}{}", store::process_run, plan.process);
}

std::set<int> StoredCells::rounds_missing(const CellRun& cell) const {
    const auto done = store_.rounds_done(build_, cell.row().hash);
    std::set<int> missing;
    for (int round = 0; round < plan_.rounds; ++round)
        if (!done.contains(round)) missing.insert(round);
    return missing;
}

namespace {

/// Returns the finalists of one scene and body, as "gjk points_soa_f32".
std::vector<std::string> finalists(const std::vector<store::StoredCell>& cells, const store::CellRow& of) {
    std::vector<std::pair<const store::StoredCell*, double>> times;
    std::map<std::string, double> fastest;  // by precision
    for (const store::StoredCell& cell : cells) {
        const auto ns = cell.figure(store::all_time.ns).value;
        if (!ns || cell.run != store::sweep_run || !cell.axes.empty() || cell.scene != of.scene ||
            cell.scene_parameters != of.scene_parameters || cell.shape != of.shape)
            continue;
        times.emplace_back(&cell, *ns);
        double& least = fastest.try_emplace(cell.precision, *ns).first->second;
        least = std::min(least, *ns);
    }
    std::vector<std::string> pairs = {fmt::format("{} {}", baseline_algorithm, baseline_table)};
    for (const auto& [cell, ns] : times)
        if (ns <= store::fast_ratio * fastest[cell->precision])
            pairs.push_back(cell->algorithm + " " + cell->table);
    return pairs;
}

}  // namespace

void keep_finalists(SweepWork& work, const std::string& path) {
    const store::StoredBuild stored = store::read_build(path, bench::this_build().id);
    std::vector<SceneWork> scenes;
    for (const SceneWork& scene : work.scenes) {
        for (const scene::NamedShape* shape : scene.shapes) {
            SceneWork& one = scenes.emplace_back(scene);
            one.shapes = {shape};
            one.choice.pairs = finalists(stored.cells, row_of(work.plan, scene, *shape));
        }
    }
    work.scenes = std::move(scenes);
}

std::optional<double> took_in(const store::Store& store, const std::string& what) {
    const auto text = store.meta(store::took_key + what);
    return text ? input::parse_number(*text).value : std::nullopt;
}

std::map<std::string, double> seconds_in(const std::string& store) {
    const std::string key_start = store::took_key;
    std::map<std::string, double> seconds;
    for (const auto& [key, value] : store::MergeSource(store).meta) {
        const auto number = key.starts_with(key_start) ? input::parse_number(value) : Result<double>{};
        if (number && *number >= 0) seconds[key.substr(key_start.size())] = *number;
    }
    return seconds;
}

void StoredCells::put(const CellRun& cell) {
    const auto& figures = cell.figures();
    store_.put_cell(build_, cell.row(),
                    cell.verified() ? store_.with_stored_figures(build_, cell.row().hash, figures) : figures);
}

void StoredCells::put_heat(const CellRun& cell, const Polyhedron& body) {
    const std::string heat = cell.heat_on_body();
    if (heat.empty()) return;
    store_.set_meta(store::body_key + cell.row().shape, body_json(body));
    store_.set_meta(store::heat_key + cell.row().hash, heat);
}

void StoredCells::put_seconds(const std::string& of, double seconds) {
    store_.set_meta(store::took_key + name_of_time(of), fmt::format("{:.3f}", seconds));
}

void StoredCells::put_others(const store::CellRow& of, double share) {
    const std::string key = store::others_key_of(build_, of);
    const auto before = store_.meta(key);
    if (share > 0 && (!before || share > input::parse_number(*before).value.value_or(0)))
        store_.set_meta(key, fmt::format("{:.4f}", share));
}

bool StoredCells::lacks_probes(const store::StoredCell& stored) const {
    if (stored.axes.find("build=default") != std::string::npos) return false;  // time and error alone
    return std::ranges::any_of(std::array{"bytes", "time"}, [&](std::string_view probe) {
        const bool wanted = plan_.probes.empty() || std::ranges::count(plan_.probes, probe) > 0;
        return wanted && std::ranges::count(stored.figures, probe, &store::FigureRow::probe) == 0;
    });
}

bool StoredCells::lacks_checks(const store::StoredCell& stored) const {
    const auto wanted = static_cast<double>(
        std::min<std::uint64_t>(plan_.checked, static_cast<std::uint64_t>(stored.queries)));
    const auto checked = stored.figure("error.checked").value;
    return checked ? *checked < wanted : stored.verified();
}

}  // namespace edgewise::sweep
