// SPDX-License-Identifier: MIT
//
// The error tables. Sums and worst values run over the cells that have the figure; how many lack it is shown.
#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "edgewise/reports/tables/summary.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

constexpr SummaryColumn error_columns[] = {{"checked", "error.checked", true},
                                           {"separated", "error.separated", true},
                                           {"touching", "error.touching", true},
                                           {"overlapping", "error.overlapping", true},
                                           {"worst error, given bodies", "error.worst_error_given", false},
                                           {"worst error, stored bodies", "error.worst_error_stored", false},
                                           {"p99 error, stored bodies", "error.p99_error_stored", false},
                                           {"witness error", "error.witness_error", false},
                                           {"wrong verdicts", "error.wrong_verdicts", true},
                                           {"verdicts in band", "error.verdicts_in_band", true},
                                           {"fallbacks", "error.fallbacks", true},
                                           {"refinements", "error.refinements", true},
                                           {"escapes", "error.escapes", true},
                                           {"cycles", "error.cycles", true},
                                           {"mean steps", "error.mean_steps", false},
                                           {"max steps", "error.max_steps", false}};

}  // namespace

TextGrid error_summary_grid(const ReportData& data) {
    std::map<std::pair<std::string, std::string>, std::vector<const ReportCell*>> groups;
    for (const ReportCell& cell : data.cells)
        if (cell.verified()) groups[{cell.algorithm, cell.table}].push_back(&cell);
    TextGrid grid{"Over all verified cells: sums of counts, worst of the rest",
                  columns_of("algorithm|table type|#cells"),
                  {}};
    for (const SummaryColumn& column : error_columns) grid.columns.push_back({column.title, true});
    for (const auto& [name, cells] : groups) {
        std::vector<GridCell> row = grid_row(name.first, name.second, cells.size());
        for (const SummaryColumn& column : error_columns) row.push_back(summary_cell(cells, column));
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

TextGrid error_grid(const ReportData& data) {
    TextGrid grid{"Every cell", columns_of("scene|shape|algorithm|table type|status"), {}};
    for (const SummaryColumn& column : error_columns) grid.columns.push_back({column.title, true});
    for (const ReportCell& cell : data.cells) {
        std::vector<GridCell> row =
            grid_row(cell.scene_label, cell.shape, cell.algorithm, cell.table, cell.status);
        for (const SummaryColumn& column : error_columns)
            row.push_back(figure_cell(cell.figure(column.figure)));
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

}  // namespace edgewise::reports
