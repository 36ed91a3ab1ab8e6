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

constexpr SummaryColumn columns[] = {{"checked", "checked", true},
                                     {"separated", "separated", true},
                                     {"touching", "touching", true},
                                     {"overlapping", "overlapping", true},
                                     {"worst error, given bodies", "worst_error_given", false},
                                     {"worst error, stored bodies", "worst_error_stored", false},
                                     {"p99 error, stored bodies", "p99_error_stored", false},
                                     {"witness error", "witness_error", false},
                                     {"wrong verdicts", "wrong_verdicts", true},
                                     {"verdicts in band", "verdicts_in_band", true},
                                     {"fallbacks", "fallbacks", true},
                                     {"refinements", "refinements", true},
                                     {"escapes", "escapes", true},
                                     {"cycles", "cycles", true},
                                     {"mean steps", "mean_steps", false},
                                     {"max steps", "max_steps", false}};

}  // namespace

TextGrid error_summary_grid(const ReportData& data) {
    std::map<std::pair<std::string, std::string>, std::vector<const ReportCell*>> groups;
    for (const ReportCell& cell : data.cells)
        if (cell.verified()) groups[{cell.algorithm, cell.table}].push_back(&cell);
    TextGrid grid{"Over all verified cells: sums of counts, worst of the rest",
                  {{"algorithm"}, {"table type"}, {"cells", true}},
                  {}};
    for (const SummaryColumn& column : columns) grid.columns.push_back({column.title, true});
    for (const auto& [name, cells] : groups) {
        std::vector<GridCell> row{{name.first}, {name.second}, {std::to_string(cells.size())}};
        for (const SummaryColumn& column : columns) row.push_back(summary_cell(cells, "error", column));
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

TextGrid error_grid(const ReportData& data) {
    TextGrid grid{"Every cell", {{"scene"}, {"shape"}, {"algorithm"}, {"table type"}, {"status"}}, {}};
    for (const SummaryColumn& column : columns) grid.columns.push_back({column.title, true});
    for (const ReportCell& cell : data.cells) {
        std::vector<GridCell> row{
            {cell.scene_label}, {cell.shape}, {cell.algorithm}, {cell.table}, {cell.status}};
        for (const SummaryColumn& column : columns)
            row.push_back(figure_cell(cell.figure("error", column.name)));
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

}  // namespace edgewise::reports
