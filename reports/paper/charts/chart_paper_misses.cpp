// SPDX-License-Identifier: MIT
//
// Misses a query in the modelled caches of 2001 against the angle a step: a row of panels a cache level, a
// column a number of vertices.
#include <fmt/core.h>

#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/chapter/thrash_scenes.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

void add_cell(const ReportCell& cell, Omissions& omitted, ChartJson& values) {
    const auto step = scene_number(cell, "rotation_step");
    if (!step || *step <= 0) return;
    for (const OldLevel& level : old_levels) {
        const measure::Figure misses = cell.figure(store::level_misses.of(level.machine, level.level));
        if (!cell.verified() || !misses.value) {
            omitted.add(fmt::format("{}: {}", level.label, misses.reason));
            continue;
        }
        ChartJson row = curve_json(cell);
        row["level"] = level.label;
        row["angle"] = *step;
        row["misses"] = *misses.value;
        values.push_back(std::move(row));
    }
}

ChartJson levels_in_order() {
    ChartJson labels = ChartJson::array();
    for (const OldLevel& level : old_levels) labels.push_back(level.label);
    return labels;
}

ChartJson spec_of(const ReportData& data, const ChartJson& values) {
    Curves curves;
    curves.x = {"angle", "angle a step, rad", log_scale(), ticks_at({0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 3})};
    curves.y = {"misses", "misses a query", scale_with_zero(1)};
    curves.has_interval = false;
    curves.width = 300;
    curves.height = 200;
    const ChartJson row{
        {"field", "level"}, {"type", "nominal"}, {"title", nullptr}, {"sort", levels_in_order()}};
    const ChartJson column{{"field", "vertices"}, {"type", "ordinal"}, {"title", "vertices of a body"}};
    return {{"config", chart_config()},
            {"data", {{"values", values}}},
            {"facet", {{"row", row}, {"column", column}}},
            {"spec", curve_layers(data, values, curves)}};
}

}  // namespace

Chart paper_misses_chart(const ReportData& data) {
    Chart chart{
        "paper_thrash_misses",
        "Misses in the caches of 2001 against angular speed",
        "Modelled misses a query in the steady pass, 300 bodies with tables of their own: a row a cache "
        "level, a column a number of vertices, a line an algorithm on a table type; the dash tells "
        "precision and axes, such as one table for all bodies (sharing=shared) or another order of the "
        "vertices. A cache that thrashes misses nearly every line that a query touches; then its curve "
        "no longer rises with the angle.",
        nullptr,
        {},
        {},
        thrash_section};
    Omissions omitted;
    ChartJson values = ChartJson::array();
    for (const int vertices : thrash_vertices)
        for (const ReportCell* cell : scene_file(data, fmt::format("paper_thrash_{}", vertices)).cells)
            add_cell(*cell, omitted, values);
    if (values.empty()) return chart;
    omitted.write("cell", chart.notes);
    thin(values, mark_limit / 2, chart.notes);
    chart.spec = spec_of(data, values);
    chart.fallback = data_grid(values, {"level", "vertices", "angle", "algorithm", "table", "misses"});
    return chart;
}

}  // namespace edgewise::reports
