// SPDX-License-Identifier: MIT
//
// A user's own scenes from files: time against the number that a scene varies, or against vertices.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/paper/charts/rotation_angle.hpp"

namespace edgewise::reports {

namespace {

bool all_positive(const ChartJson& values) {
    return std::all_of(values.begin(), values.end(),
                       [](const ChartJson& row) { return row["place"].get<double>() > 0; });
}

ChartJson own_scenes_values_of(const StoredScene& scene, Omissions& omitted) {
    ChartJson values = ChartJson::array();
    for (const ReportCell* cell : scene.cells) {
        const auto place = scene.place(*cell);
        if (!place) {
            omitted.add("its scene parameters do not hold " + scene.varied);
            continue;
        }
        ChartJson row = timed_row(*cell, store::all_time, omitted);
        if (row.is_null()) continue;
        row["place"] = *place;
        if (scene.varied == "rotation_step" && has_random_orientation(*cell)) {
            row["place"] = random_angle;
            row["larger"] = row["unjoined"] = true;
            row["point"] = cell->algorithm + ", random orientations";
        }
        // Bodies of one shape are joined over what varies; else the shapes are.
        if (!scene.varied.empty()) row["stroke"] = row["stroke"].get<std::string>() + " " + cell->shape;
        values.push_back(std::move(row));
    }
    return values;
}

/// Names of files and elements hold letters, digits, '_' and '-' only.
std::string safe(std::string name) {
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
    return name;
}

Chart chart_of(const ReportData& data, const StoredScene& scene) {
    Chart chart = chart_of_file("own_scene");
    const std::string axis = scene.axis_title();
    chart.name = "scene_" + safe(scene.name);
    chart.title =
        fmt::format(fmt::runtime(chart.title), fmt::arg("name", scene.name), fmt::arg("axis", axis));
    chart.how_to_read = fmt::format(fmt::runtime(chart.how_to_read), fmt::arg("note", scene.note));
    Omissions omitted;
    ChartJson values = own_scenes_values_of(scene, omitted);
    if (!take_rows(chart, values, omitted)) return chart;
    draw(chart, data, values,
         {{"axis_title", axis},
          {"scale_of_places", chart.file["scales"][all_positive(values) ? "log" : "linear"]}});
    return chart;
}

}  // namespace

std::vector<Chart> own_scene_charts(const ReportData& data) {
    std::vector<Chart> charts;
    for (const StoredScene& scene : scene_files(data))
        if (!is_of_paper(scene.name)) charts.push_back(chart_of(data, scene));
    return charts;
}

}  // namespace edgewise::reports
