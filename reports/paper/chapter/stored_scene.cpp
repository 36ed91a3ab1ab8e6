// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/chapter/stored_scene.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

StoredScene parse(const std::string& name, const std::string& text) {
    const nlohmann::json file = input::json_or_null(text), vary = input::member_of(file, "vary");
    StoredScene scene{name, {}, input::text_member(file, "note"), {}};
    if (vary.is_object())
        for (const auto& item : vary.items()) scene.varied = item.key();
    return scene;
}

}  // namespace

std::optional<double> StoredScene::place(const ReportCell& cell) const {
    if (varied.empty()) return static_cast<double>(cell.vertices);
    return parameter_of(cell, varied);
}

std::string StoredScene::axis_title() const {
    return varied.empty() ? "vertices of a body" : in_words(varied);
}

std::vector<StoredScene> scene_files(const ReportData& data) {
    std::vector<StoredScene> scenes;
    for (const auto& [name, text] : data.scene_files) {
        scenes.push_back(parse(name, text));
        for (const ReportCell& cell : data.from_files)
            if (cell.scene == name) scenes.back().cells.push_back(&cell);
    }
    return scenes;
}

StoredScene scene_file(const ReportData& data, const std::string& name) {
    for (StoredScene& scene : scene_files(data))
        if (scene.name == name) return scene;
    return {name, {}, {}, {}};
}

bool is_of_paper(const std::string& scene) {
    return std::ranges::find(paper_scenes, scene) != std::end(paper_scenes);
}

const ReportCell* nearest_cell(const StoredScene& scene, const std::string& algorithm,
                               const std::string& table, double wanted) {
    const ReportCell* nearest = nullptr;
    double least = 0;
    for (const ReportCell* cell : scene.cells) {
        if (!cell->verified() || cell->algorithm != algorithm || cell->table != table) continue;
        const auto place = scene.place(*cell);
        if (!place) continue;
        const double off = std::abs(*place - wanted);
        if (!nearest || off < least) nearest = cell, least = off;
    }
    return nearest;
}

namespace {

constexpr const char *thrash_algorithm = "vclip", *thrash_table = "aos_f64";

/// Returns V-Clip's cell with the slowest or the fastest rotation; null if the store has no cell.
const ReportCell* end_cell(const ReportData& data, int vertices, bool fastest) {
    const auto cells = thrash_cells(data, vertices, thrash_algorithm, thrash_table);
    if (cells.empty()) return nullptr;
    return fastest ? cells.back().second : cells.front().second;
}

measure::Expected<double> no_cell(int vertices) {
    return measure::Expected<double>::none(fmt::format(
        "the store has no verified cell of paper_thrash_{} with V-Clip on {}", vertices, thrash_table));
}

bool gives_the_time(const ReportData& data, const std::string& machine, bool fastest) {
    const measure::Expected<double> time =
        thrash_figure(data, 386, fastest, store::memory_time.of(machine).warm());
    return time.value && *time.value >= least_share * papers_growth_ns;
}

/// Returns true if a row of the paging run faults often with as much memory for the tables as a machine of
/// the time had; null for rows other than V-Clip on aos_f64, 386 vertices, hundreds of bodies.
std::optional<bool> faults_in_old_memory(const ReportCell& row) {
    const bool ours = row.verified() && row.algorithm == thrash_algorithm && row.table == thrash_table &&
                      row.vertices == 386;
    if (!ours || parameter_of(row, "bodies").value_or(more_than_hundreds) >= more_than_hundreds)
        return std::nullopt;
    std::optional<bool> found;
    for (const PagingLimit& limit : paging_limits(row)) {
        if (!limit.faults.value || limit.held.value.value_or(0) < least_old_memory) continue;
        found = found.value_or(false) || *limit.faults.value >= least_faults;
    }
    return found;
}

}  // namespace

std::vector<std::pair<double, const ReportCell*>> thrash_cells(const ReportData& data, int vertices,
                                                               const std::string& algorithm_name,
                                                               const std::string& table_name) {
    std::vector<std::pair<double, const ReportCell*>> cells;
    for (const ReportCell* cell : thrash_scene(data, vertices).cells) {
        const auto step = parameter_of(*cell, "rotation_step");
        if (step && cell->verified() && cell->algorithm == algorithm_name && cell->table == table_name)
            cells.emplace_back(*step, cell);
    }
    std::ranges::sort(cells, [](const auto& a, const auto& b) { return a.first < b.first; });
    return cells;
}

measure::Expected<double> thrash_figure(const ReportData& data, int vertices, bool fastest,
                                        const store::FigureName& name) {
    const ReportCell* cell = end_cell(data, vertices, fastest);
    if (!cell) return no_cell(vertices);
    const measure::Figure figure = cell->figure(name);
    if (figure.value) return {figure.value, {}};
    return {std::nullopt, fmt::format("{} at {} vertices: {}", name.name(), vertices, figure.reason)};
}

measure::Expected<double> thrash_number(const ReportData& data, int vertices, bool fastest,
                                        const std::string& name) {
    const ReportCell* cell = end_cell(data, vertices, fastest);
    if (!cell) return no_cell(vertices);
    return {parameter_of(*cell, name), "the scene's parameters do not name its " + name};
}

measure::Expected<double> worst_figure(const ReportData& data, int vertices, const store::FigureName& name) {
    const measure::Expected<double> slow = thrash_figure(data, vertices, false, name),
                                    fast = thrash_figure(data, vertices, true, name);
    if (slow.value && fast.value) return {std::max(*slow.value, *fast.value), {}};
    return slow.value ? slow : fast;
}

measure::Expected<double> bodies_to_fill(const ReportData& data, int vertices, const store::FigureName& knee,
                                         double bytes) {
    const measure::Expected<double> worst = worst_figure(data, vertices, knee),
                                    bodies = thrash_number(data, vertices, false, "bodies");
    if (!worst.value) return worst;
    if (!bodies.value) return bodies;
    if (*worst.value <= 0) return {std::numeric_limits<double>::infinity(), {}};
    return {*bodies.value * bytes / *worst.value, {}};
}

measure::Expected<double> memory_factor(const ReportData& data, const std::string& machine, bool fastest) {
    const store::FigureName name = store::memory_time.of(machine).warm();
    const measure::Expected<double> large = thrash_figure(data, 386, fastest, name),
                                    small = thrash_figure(data, 38, fastest, name);
    if (!large.value) return large;
    if (!small.value) return small;
    if (*small.value > 0) return {*large.value / *small.value, {}};
    return {*large.value > 0 ? std::numeric_limits<double>::infinity() : 1, {}};
}

std::optional<bool> cache_is_a_cause(const ReportData& data) {
    std::optional<bool> found;
    for (const char* machine : old_machines) {
        for (const bool fastest : {false, true}) {
            const measure::Expected<double> factor = memory_factor(data, machine, fastest);
            if (!factor.value) continue;
            const bool enough = *factor.value >= papers_factor && gives_the_time(data, machine, fastest);
            found = found.value_or(false) || enough;
        }
    }
    return found;
}

std::optional<bool> paging_is_a_cause(const ReportData& data) {
    std::optional<bool> found;
    const measure::Expected<double> large =
                                        bodies_to_fill(data, 386, store::page_knee.warm(), least_old_memory),
                                    small =
                                        bodies_to_fill(data, 38, store::page_knee.warm(), least_old_memory);
    const bool at_38 = small.value && *small.value < more_than_hundreds;
    if (large.value) found = *large.value < more_than_hundreds && !at_38;
    for (const ReportCell& row : data.paging)
        if (const auto measured = faults_in_old_memory(row)) found = found.value_or(false) || *measured;
    return found;
}

std::vector<PagingLimit> paging_limits(const ReportCell& row) {
    std::vector<PagingLimit> limits;
    for (int i = 0;; ++i) {
        const std::string number = std::to_string(i);
        const std::string limit = store::FigureName("paging.limit_bytes.{limit}").of(number).name();
        const auto is_limit = [&](const store::FigureRow& figure) {
            return figure.probe == "paging" && figure.name == limit;
        };
        if (std::ranges::none_of(row.figures, is_limit)) return limits;
        const auto figure = [&](const store::FigureName& name) { return row.figure(name.of(number)); };
        limits.push_back(
            {figure("paging.limit_bytes.{limit}"), figure("paging.held_bytes.{limit}"),
             figure("paging.faults_per_query.{limit}"), figure("paging.predicted_at_held.{limit}"),
             figure("paging.predicted_at_limit.{limit}"), figure("paging.us_per_query.{limit}")});
    }
}

}  // namespace edgewise::reports
