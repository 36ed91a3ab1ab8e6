// SPDX-License-Identifier: MIT
//
// Misses per query in the modelled caches of 2001 against the angle per step: a row of panels per cache
// level, a column a number of vertices.
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

}  // namespace

Chart paper_misses_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_thrash_misses");
    Omissions omitted;
    ChartJson values = ChartJson::array();
    for (const int vertices : thrash_vertices)
        for (const ReportCell* cell : scene_file(data, fmt::format("paper_thrash_{}", vertices)).cells)
            add_cell(*cell, omitted, values);
    if (take_rows(chart, values, omitted)) draw(chart, data, values, {{"levels", levels_in_order()}});
    return chart;
}

}  // namespace edgewise::reports
