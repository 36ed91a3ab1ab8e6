// SPDX-License-Identifier: MIT
//
// Misses per query against the size of a fully associative cache, of lines and of pages, at one angle per
// step: a row of panels per number of vertices. The cache and the memories of 2001 stand as rules in every
// panel.
#include <fmt/core.h>

#include <cmath>
#include <set>

#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/chapter/thrash_scenes.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

void add_curve(const ReportCell& cell, const store::ReuseNames& family, ChartJson& values) {
    for (const store::FigureRow& figure : cell.figures) {
        const auto power = family.misses.value_in(figure.probe, figure.name);
        if (!power || !figure.value) continue;
        ChartJson row = curve_json(cell);
        row["unit"] = family.units;
        row["bytes"] = std::ldexp(1.0, std::stoi(*power));
        row["misses"] = *figure.value;
        values.push_back(std::move(row));
    }
}

/// The scene's cells whose angle per step is nearest to the one that is shown.
void add_scene(const StoredScene& scene, ChartJson& values) {
    std::set<std::pair<std::string, std::string>> done;
    for (const ReportCell* cell : scene.cells) {
        if (!done.emplace(cell->algorithm, cell->table).second) continue;
        const ReportCell* shown = nearest_cell(scene, cell->algorithm, cell->table, thrash_step_angle);
        if (!shown) continue;
        for (const store::ReuseNames& family : store::reuse_names) add_curve(*shown, family, values);
    }
}

/// Rules are rows too: a layer with data of its own would stand in every panel.
void add_rules(ChartJson& values) {
    struct Rule {
        const char *unit, *label;
        double bytes;
    };
    const Rule rules[] = {{"lines", "L2 of 2001", old_cache},
                          {"pages", "64 MiB", least_old_memory},
                          {"pages", "256 MiB", most_old_memory}};
    std::set<std::pair<std::string, std::int64_t>> panels;
    for (const ChartJson& row : values)
        panels.emplace(row["unit"].get<std::string>(), row["vertices"].get<std::int64_t>());
    for (const auto& [unit, vertices] : panels)
        for (const Rule& rule : rules)
            if (unit == rule.unit)
                values.push_back(
                    {{"unit", unit}, {"vertices", vertices}, {"rule", rule.bytes}, {"label", rule.label}});
}

}  // namespace

Chart paper_reuse_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_thrash_reuse");
    ChartJson values = ChartJson::array();
    for (const int vertices : thrash_vertices)
        add_scene(scene_file(data, fmt::format("paper_thrash_{}", vertices)), values);
    if (!take_rows(chart, values)) return chart;
    add_rules(values);
    draw(chart, data, values);
    return chart;
}

}  // namespace edgewise::reports
