// SPDX-License-Identifier: MIT
//
// The paging run: one row per limit.
#include "edgewise/reports/paper/chapter/paging_limits.hpp"
#include "edgewise/reports/paper/chapter/paper_thrash.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

GridCell mebibytes(const measure::Figure& figure) {
    return figure.value ? GridCell{number_text(*figure.value / 1048576)} : figure_cell(figure);
}

}  // namespace

TextGrid paging_grid(const ReportData& data) {
    TextGrid grid{"Page faults per query under memory limits",
                  columns_of("shape|algorithm|table type|#bodies|#tables, MiB|#touched, MiB|#limit, MiB|"
                             "#left to tables, MiB|#predicted|#measured|#us per query"),
                  {}};
    for (const ReportCell& row : data.paging) {
        const auto bodies = scene_number(row, "bodies");
        for (const PagingLimit& limit : paging_limits(row))
            grid.rows.push_back(
                grid_row(row.shape, row.algorithm, row.table, bodies ? number_text(*bodies) : "–",
                         mebibytes(row.figure("paging.table_bytes")),
                         mebibytes(row.figure("paging.touched_bytes")), mebibytes(limit.limit),
                         mebibytes(limit.held), limit.predicted_at_held, limit.faults, limit.us));
    }
    return grid;
}

}  // namespace edgewise::reports
