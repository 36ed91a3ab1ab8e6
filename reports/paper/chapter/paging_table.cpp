// SPDX-License-Identifier: MIT
//
// The paging run: one row a limit.
#include "edgewise/reports/paper/chapter/paging_limits.hpp"
#include "edgewise/reports/paper/chapter/paper_thrash.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/tables/text.hpp"

namespace edgewise::reports {

namespace {

GridCell mebibytes(const measure::Figure& figure) {
    return figure.value ? GridCell{number_text(*figure.value / 1048576)} : figure_cell(figure);
}

}  // namespace

TextGrid paging_grid(const ReportData& data) {
    TextGrid grid{"Page faults a query under memory limits",
                  {{"shape"},
                   {"algorithm"},
                   {"table type"},
                   {"bodies", true},
                   {"tables, MiB", true},
                   {"touched, MiB", true},
                   {"limit, MiB", true},
                   {"left to tables, MiB", true},
                   {"predicted", true},
                   {"measured", true},
                   {"us a query", true}},
                  {}};
    for (const ReportCell& row : data.paging) {
        const auto bodies = scene_number(row, "bodies");
        for (const PagingLimit& limit : paging_limits(row))
            grid.rows.push_back({{row.shape},
                                 {row.algorithm},
                                 {row.table},
                                 {bodies ? number_text(*bodies) : "–"},
                                 mebibytes(row.figure("paging.table_bytes")),
                                 mebibytes(row.figure("paging.touched_bytes")),
                                 mebibytes(limit.limit),
                                 mebibytes(limit.held),
                                 figure_cell(limit.predicted_at_held),
                                 figure_cell(limit.faults),
                                 figure_cell(limit.us)});
    }
    return grid;
}

}  // namespace edgewise::reports
