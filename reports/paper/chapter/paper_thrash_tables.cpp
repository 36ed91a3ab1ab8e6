// SPDX-License-Identifier: MIT
//
// What layouts and sharing do to the thrash, at every number of vertices and angle per step; and the
// paging run, one row per limit.
#include <fmt/core.h>

#include "edgewise/reports/paper/chapter/paper_thrash.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/chapter/thrash_evidence.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

std::vector<FigureColumn> thrash_columns() {
    std::vector<FigureColumn> columns = {{"line knee, KiB", store::line_knee.warm(), kibibyte},
                                         {"page knee, MiB", store::page_knee.warm(), mebibyte},
                                         {"lines per query", store::reuse_names[0].per_query.warm()},
                                         {"pages per query", store::reuse_names[1].per_query.warm()}};
    for (const OldLevel& level : old_levels)
        columns.push_back({std::string(level.label) + ": misses",
                           store::level_misses.of(level.machine, level.level).warm()});
    for (const char* machine : old_machines)
        columns.push_back(
            {std::string(machine) + " memory, us", store::memory_time.of(machine).warm(), 1000});
    return columns;
}

}  // namespace

TextGrid thrash_grid(const ReportData& data) {
    const std::vector<FigureColumn> columns = thrash_columns();
    TextGrid grid = figure_grid(
        "The thrash by table: knees, lines and pages per query touches, modelled misses and memory time",
        "#vertices|#rad per step|algorithm|table type", columns);
    for (const int vertices : thrash_vertices) {
        for (const ReportCell* cell : thrash_scene(data, vertices).cells) {
            const auto step = scene_number(*cell, "rotation_step");
            if (cell->verified() && step)
                add_row(grid, grid_row(vertices, number_text(*step), cell->algorithm, cell->table), *cell,
                        columns);
        }
    }
    return grid;
}

TextGrid paging_grid(const ReportData& data) {
    TextGrid grid{"Page faults per query under memory limits",
                  columns_of("shape|algorithm|table type|#bodies|#tables, MiB|#touched, MiB|#limit, MiB|"
                             "#left to tables, MiB|#predicted|#measured|#us per query")};
    for (const ReportCell& row : data.paging) {
        const auto bodies = scene_number(row, "bodies");
        for (const PagingLimit& limit : paging_limits(row))
            grid.add(row.shape, row.algorithm, row.table, bodies ? number_text(*bodies) : "–",
                     figure_cell(row.figure("paging.table_bytes"), mebibyte),
                     figure_cell(row.figure("paging.touched_bytes"), mebibyte),
                     figure_cell(limit.limit, mebibyte), figure_cell(limit.held, mebibyte),
                     limit.predicted_at_held, limit.faults, limit.us);
    }
    return grid;
}

}  // namespace edgewise::reports
