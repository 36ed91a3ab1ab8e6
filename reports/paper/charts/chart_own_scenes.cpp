// SPDX-License-Identifier: MIT
//
// A user's own scenes from files: time against the number that a scene varies, or against vertices.
#include <algorithm>
#include <cctype>

#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/paper/charts/turn.hpp"

namespace edgewise::reports {

namespace {

bool all_positive(const ChartJson& values) {
    return std::all_of(values.begin(), values.end(),
                       [](const ChartJson& row) { return row["place"].get<double>() > 0; });
}

ChartJson values_of(const StoredScene& scene, Omissions& omitted) {
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
        if (scene.varied == "rotation_step" && is_random_turn(*cell)) {
            row["place"] = random_turn;
            row["apart"] = row["unjoined"] = true;
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
    Chart chart{"scene_" + safe(scene.name),
                scene.name + ": time against " + scene.axis_title(),
                "Each line is an algorithm on a table type: median time of all queries, separated and "
                "overlapping as they come, with its 95 % interval. " +
                    scene.note,
                nullptr,
                {},
                {},
                own_section};
    Omissions omitted;
    ChartJson values = values_of(scene, omitted);
    omitted.write("cell", chart.notes);
    if (values.empty()) return chart;
    thin(values, mark_limit / 3, chart.notes);
    Curves curves;
    curves.x = {"place", scene.axis_title(), {{"nice", true}, {"zero", false}}};
    if (all_positive(values)) curves.x.scale = log_scale();
    curves.y = {"ns", "ns a query, median", scale_from_zero()};
    chart.spec = curve_spec(data, values, curves);
    chart.fallback = data_grid(values, {"place", "shape", "algorithm", "table", "ns", "low", "high"});
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
