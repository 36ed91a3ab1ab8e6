// SPDX-License-Identifier: MIT
//
// The labels of scenes: from a scene's own parameters alone, so that a scene is called the same in every
// store and can be cited. Parameters that are no JSON object are shown as they are.
#include "edgewise/reports/scene_label.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "edgewise/input/json_text.hpp"

namespace edgewise::reports {

namespace {

using SceneLabelJson = nlohmann::json;

SceneLabelJson parse_parameters(const std::string& text) {
    SceneLabelJson parsed = input::json_or_null(text);
    if (parsed.is_object()) return parsed;
    return text.empty() ? SceneLabelJson::object() : SceneLabelJson{{"parameters", text}};
}

std::string shown(const SceneLabelJson& value) {
    if (value.is_string()) return value.get<std::string>();
    const double number = value.is_number() ? value.get<double>() : 0.5;
    return std::floor(number) == number ? fmt::format("{:.0f}", number) : value.dump();
}

const SceneStandard* standard_of(std::string_view kind, std::string_view parameter) {
    const auto standards = scene_standards();
    const auto found = std::find_if(standards.begin(), standards.end(), [&](const SceneStandard& standard) {
        return standard.kind == kind && standard.parameter == parameter;
    });
    return found == standards.end() ? nullptr : &*found;
}

bool goes_without_saying(const std::string& kind, const std::string& name, const SceneLabelJson& value) {
    const SceneStandard* standard = standard_of(kind, name);
    return standard && !standard->always_said && value.is_number() && value.get<double>() == standard->value;
}

std::string label(const std::string& scene, const std::vector<std::string>& inside) {
    return inside.empty() ? scene : fmt::format("{} ({})", scene, fmt::join(inside, ", "));
}

/// The parameter that a scene file varies; empty: none.
std::string varied_by(const SceneLabelJson& file) {
    const SceneLabelJson vary = file.is_object() ? file.value("vary", SceneLabelJson()) : SceneLabelJson();
    return vary.is_object() && !vary.empty() ? vary.begin().key() : std::string();
}

}  // namespace

std::span<const SceneStandard> scene_standards() {
    static constexpr SceneStandard standards[] = {{"static", "occupancy", 0.1},
                                                  {"static", "bodies", 64},
                                                  {"static", "margin", 0},
                                                  {"cold", "distance", 1},
                                                  {"cold", "overlapping", 0.1},
                                                  {"cold", "deepest", 0.5},
                                                  {"gap", "gap", -0.1, true},
                                                  {"gap", "span", 1.1},
                                                  {"tumble", "rotation_step", 0.01, true},
                                                  {"tumble", "translation_step", 0.001},
                                                  {"tumble", "bodies", 12},
                                                  {"tumble", "occupancy", 0.1},
                                                  {"tumble", "margin", 0.2},
                                                  {"tumble", "steps", 100},
                                                  {"tumble", "in_time_order", 0},
                                                  {"tumble", "step_in_dimensions", 0},
                                                  {"tumble", "random_orientation", 0},
                                                  {"tumble", "random_velocities", 0},
                                                  {"tumble", "own_tables", 0},
                                                  {"tumble", "box_of_bodies", 0},
                                                  {"tumble", "precession", 0},
                                                  {"tumble", "least_steps", 0},
                                                  {"tumble", "population", 0},
                                                  {"proximity", "pairs", 30},
                                                  {"proximity", "gap", 0.001},
                                                  {"proximity", "rotation_step", 0.25 / 60},
                                                  {"pressure", "bodies", 600, true},
                                                  {"pressure", "rotation_step", 0.1},
                                                  {"pressure", "gap", 0.1},
                                                  {"pressure", "new_order", 0},
                                                  {"pressure", "least_steps", 0},
                                                  {"pressure", "own_tables", 1}};
    return standards;
}

std::optional<double> parameter_of(const store::CellRow& cell, const std::string& name) {
    const SceneLabelJson parameters = input::json_or_null(cell.scene_parameters);
    if (!parameters.is_object() || !parameters.contains(name) || !parameters[name].is_number())
        return std::nullopt;
    return parameters[name].get<double>();
}

std::string scene_label(const store::CellRow& cell, const std::string& file_text) {
    const SceneLabelJson parameters = parse_parameters(cell.scene_parameters);
    const SceneLabelJson file = input::json_or_null(file_text);
    const std::string varied = varied_by(file);
    if (!varied.empty() && parameters.contains(varied))
        return label(cell.scene, {varied + " " + shown(parameters[varied])});
    if (file.is_object() && varied.empty()) return cell.scene;
    const std::string kind = file.is_object() ? file.value("scene", cell.scene) : cell.scene;
    std::vector<std::string> inside;
    for (const auto& [name, value] : parameters.items())
        if (!goes_without_saying(kind, name, value)) inside.push_back(name + " " + shown(value));
    const bool of_study = cell.run != store::sweep_run && cell.scene != cell.run;
    return label(of_study ? cell.run + " " + cell.scene : cell.scene, inside);
}

}  // namespace edgewise::reports
