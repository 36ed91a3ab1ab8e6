// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/chapter/stored_scene.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

using StoredSceneJson = nlohmann::json;

StoredScene parse(const std::string& name, const std::string& text) {
    const StoredSceneJson file = input::json_or_null(text);
    StoredScene scene{name, {}, {}, {}};
    if (!file.is_object()) return scene;
    if (file.contains("note") && file["note"].is_string()) scene.note = file["note"];
    if (!file.contains("vary") || !file["vary"].is_object()) return scene;
    for (const auto& item : file["vary"].items()) scene.varied = item.key();
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

}  // namespace edgewise::reports
