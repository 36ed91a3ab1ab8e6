// SPDX-License-Identifier: MIT
//
// The tables of the stability run: over all families, and family by family.
#include <algorithm>
#include <map>

#include "edgewise/reports/tables/summary.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

constexpr SummaryColumn stability_columns[] = {
    {"cases", "stability.cases", true},
    {"refused", "stability.refused", true},
    {"in the band", "stability.in_band", true},
    {"wrong verdicts", "stability.wrong_outside_band", true},
    {"differing inside the band", "stability.wrong_inside_band", true},
    {"errors beyond the bound", "stability.errors_beyond", true},
    {"worst error", "stability.worst_error", false},
    {"p99.9 error", "stability.p999_error", false},
    {"witness error", "stability.worst_witness_error", false},
    {"depth error", "stability.worst_depth_error", false},
    {"depths beyond the bound", "stability.depths_beyond", true},
    {"cap hits", "stability.cap_hits", true},
    {"certificate width", "stability.worst_certificate_width", false},
    {"certificates that miss", "stability.certificates_missed", true},
    {"asked of the control", "stability.control_asked", true},
    {"control disagrees", "stability.control_disagrees", true},
    {"... outside the band", "stability.control_disagrees_outside_band", true},
    {"control wrong", "stability.control_wrong", true},
    {"escapes", "stability.escapes", true},
    {"cycles", "stability.cycles", true},
    {"fallbacks", "stability.fallbacks", true},
    {"refinements", "stability.refinements", true},
    {"max steps", "stability.max_steps", false}};

}  // namespace

TextGrid stability_summary_grid(const ReportData& data) {
    std::map<std::pair<std::string, std::string>, std::vector<const ReportCell*>> groups;
    for (const ReportCell& row : data.stability) groups[{row.algorithm, row.table}].push_back(&row);
    TextGrid grid{"Over all families: sums of counts, worst of the rest",
                  columns_of("algorithm|table type|#families|#failed"),
                  {}};
    for (const SummaryColumn& column : stability_columns) grid.columns.push_back({column.title, true});
    for (const auto& [name, rows] : groups) {
        const auto failed = std::count_if(rows.begin(), rows.end(),
                                          [](const ReportCell* row) { return row->status == "failed"; });
        std::vector<GridCell> cells{
            {name.first}, {name.second}, {std::to_string(rows.size())}, {std::to_string(failed)}};
        for (const SummaryColumn& column : stability_columns) cells.push_back(summary_cell(rows, column));
        grid.rows.push_back(std::move(cells));
    }
    return grid;
}

TextGrid stability_grid(const ReportData& data) {
    TextGrid grid{"Family by family", columns_of("family|algorithm|table type|status"), {}};
    for (const SummaryColumn& column : stability_columns) grid.columns.push_back({column.title, true});
    for (const ReportCell& row : data.stability) {
        std::vector<GridCell> cells{{row.shape}, {row.algorithm}, {row.table}, {row.status}};
        for (const SummaryColumn& column : stability_columns)
            cells.push_back(figure_cell(row.figure(column.figure)));
        grid.rows.push_back(std::move(cells));
    }
    return grid;
}

}  // namespace edgewise::reports
