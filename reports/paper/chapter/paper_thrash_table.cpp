// SPDX-License-Identifier: MIT
//
// What layouts, orders and sharing do to the thrash, at every number of vertices and angle per step.
#include <fmt/core.h>

#include "edgewise/reports/paper/chapter/paper_thrash.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/chapter/thrash_scenes.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

GridCell thrash_scaled(const measure::Figure& figure, double unit) {
    return figure.value ? GridCell{number_text(*figure.value / unit)} : figure_cell(figure);
}

std::vector<GridCell> thrash_row_of(int vertices, double step, const ReportCell& cell) {
    std::vector<GridCell> row =
        grid_row(vertices, number_text(step), cell.algorithm, cell.table,
                 thrash_scaled(cell.figure("reuse.line_knee_bytes"), 1024),
                 thrash_scaled(cell.figure("reuse.page_knee_bytes"), 1048576),
                 cell.figure("reuse.lines_per_query"), cell.figure("reuse.pages_per_query"));
    for (const OldLevel& level : old_levels)
        row.push_back(figure_cell(cell.figure(store::level_misses.of(level.machine, level.level))));
    for (const char* machine : old_machines)
        row.push_back(thrash_scaled(cell.figure(store::memory_time.of(machine)), 1000));
    return row;
}

}  // namespace

TextGrid thrash_grid(const ReportData& data) {
    TextGrid grid{
        "The thrash by table: knees, lines and pages per query touches, modelled misses and memory time",
        columns_of("#vertices|#rad per step|algorithm|table type|#line knee, KiB|#page knee, MiB|"
                   "#lines per query|#pages per query"),
        {}};
    for (const OldLevel& level : old_levels)
        grid.columns.push_back({std::string(level.label) + ": misses", true});
    for (const char* machine : old_machines)
        grid.columns.push_back({std::string(machine) + " memory, us", true});
    for (const int vertices : thrash_vertices) {
        for (const ReportCell* cell : scene_file(data, fmt::format("paper_thrash_{}", vertices)).cells) {
            const auto step = scene_number(*cell, "rotation_step");
            if (cell->verified() && step) grid.rows.push_back(thrash_row_of(vertices, *step, *cell));
        }
    }
    return grid;
}

}  // namespace edgewise::reports
