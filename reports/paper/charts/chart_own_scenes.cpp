// SPDX-License-Identifier: MIT
//
// A user's own scenes from files: time against the number that a scene varies, or against vertices.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

bool all_positive(const ChartJson& values) {
    return std::ranges::all_of(values, [](const ChartJson& row) { return row["place"].get<double>() > 0; });
}

/// Returns a cell's place on the axis; null, and counted, if its scene does not name it.
ChartJson own_place(const StoredScene& scene, const ReportCell& cell, Omissions& omitted) {
    const auto at = scene.place(cell);
    if (!at) {
        omitted.add("its scene parameters do not hold " + scene.varied);
        return nullptr;
    }
    ChartJson place = ChartJson::object({{"place", *at}});
    if (scene.varied == "rotation_step" && has_random_orientation(cell))
        place = {{"place", random_angle},
                 {"unjoined", true},
                 {"larger", true},
                 {"point", cell.algorithm + ", random orientations"}};
    // Bodies of one shape are joined over what varies; else the shapes are.
    if (!scene.varied.empty()) place["stroke"] = cell.algorithm + " " + cell.table + " " + cell.shape;
    return place;
}

Chart chart_of(const ReportData& data, const StoredScene& scene, const std::string& name) {
    Chart chart = chart_of_file("own_scene");
    const std::string axis = scene.axis_title();
    chart.name = name;
    chart.title =
        fmt::format(fmt::runtime(chart.title), fmt::arg("name", scene.name), fmt::arg("axis", axis));
    chart.how_to_read = fmt::format(fmt::runtime(chart.how_to_read), fmt::arg("note", scene.note));
    ChartRows rows;
    add_timed_rows(rows, scene.cells,
                   [&](const ReportCell& cell) { return own_place(scene, cell, rows.omitted); });
    const ChartJson slots{
        {"axis_title", axis},
        {"scale_of_places", chart.file["scales"][all_positive(rows.values) ? "log" : "linear"]}};
    return drawn_chart(std::move(chart), data, std::move(rows), slots);
}

}  // namespace

std::vector<Chart> own_scene_charts(const ReportData& data) {
    std::vector<Chart> charts;
    std::set<std::string> names;
    for (const StoredScene& scene : scene_files(data)) {
        if (is_of_paper(scene.name)) continue;
        const std::string name = file_name_of("scene_" + scene.name, names);
        names.insert(name);
        charts.push_back(chart_of(data, scene, name));
    }
    return charts;
}

}  // namespace edgewise::reports
