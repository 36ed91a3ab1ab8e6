// SPDX-License-Identifier: MIT
//
// The tables of errors and of the stability run. Sums and worst values run over the cells that have the
// figure; how many lack it is shown.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>

#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

using Rows = std::vector<const ReportCell*>;

struct SummaryColumn : FigureColumn {
    bool sum;  ///< add up over cells, else take the worst
};

const SummaryColumn error_columns[] = {{{"checked", "error.checked"}, true},
                                       {{"separated", "error.separated"}, true},
                                       {{"touching", "error.touching"}, true},
                                       {{"overlapping", "error.overlapping"}, true},
                                       {{"worst error, given bodies", "error.worst_error_given"}, false},
                                       {{"worst error, stored bodies", "error.worst_error_stored"}, false},
                                       {{"p99 error, stored bodies", "error.p99_error_stored"}, false},
                                       {{"witness error", "error.witness_error"}, false},
                                       {{"wrong verdicts", "error.wrong_verdicts"}, true},
                                       {{"verdicts in band", "error.verdicts_in_band"}, true},
                                       {{"fallbacks", "error.fallbacks"}, true},
                                       {{"refinements", "error.refinements"}, true},
                                       {{"escapes", "error.escapes"}, true},
                                       {{"cycles", "error.cycles"}, true},
                                       {{"mean steps", "error.mean_steps"}, false},
                                       {{"max steps", "error.max_steps"}, false}};

const SummaryColumn stability_columns[] = {
    {{"cases", "stability.cases"}, true},
    {{"refused", "stability.refused"}, true},
    {{"in the band", "stability.in_band"}, true},
    {{"wrong verdicts outside the band", "stability.wrong_outside_band"}, true},
    {{"differing inside the band", "stability.wrong_inside_band"}, true},
    {{"errors beyond the bound", "stability.errors_beyond"}, true},
    {{"worst error beyond the band", "stability.worst_error"}, false},
    {{"p99.9 error beyond the band", "stability.p999_error"}, false},
    {{"witness error beyond the bound", "stability.worst_witness_error"}, false},
    {{"depth error beyond the bound", "stability.worst_depth_error"}, false},
    {{"depths beyond the bound", "stability.depths_beyond"}, true},
    {{"cap hits", "stability.cap_hits"}, true},
    {{"certificate width", "stability.worst_certificate_width"}, false},
    {{"certificates that miss", "stability.certificates_missed"}, true},
    {{"asked of the control", "stability.control_asked"}, true},
    {{"control disagrees", "stability.control_disagrees"}, true},
    {{"... outside the band", "stability.control_disagrees_outside_band"}, true},
    {{"control wrong", "stability.control_wrong"}, true},
    {{"escapes", "stability.escapes"}, true},
    {{"cycles", "stability.cycles"}, true},
    {{"fallbacks", "stability.fallbacks"}, true},
    {{"refinements", "stability.refinements"}, true},
    {{"max steps", "stability.max_steps"}, false}};

/// Sums up a figure over the rows that have it; the cell says how many rows lack it.
GridCell summary_cell(const Rows& rows, const SummaryColumn& column) {
    measure::Figure total{column.figure.name(), std::nullopt, ""};
    std::size_t missing = 0;
    for (const ReportCell* cell : rows) {
        const measure::Figure figure = cell->figure(column.figure);
        if (!figure.value) {
            ++missing;
            if (!total.value) total.reason = figure.reason, total.remedy = figure.remedy;
            continue;
        }
        const double so_far = total.value.value_or(*figure.value);
        const bool first = !total.value;
        total.value = column.sum && !first ? so_far + *figure.value : std::max(so_far, *figure.value);
        total.unit = figure.unit;
    }
    GridCell shown = figure_cell(total);
    if (total.value && missing) shown.text += fmt::format(" ({} of {})", rows.size() - missing, rows.size());
    return shown;
}

/// A row for each algorithm and table type: its names, `counts` of its cells, and its columns.
template <class Columns, class Counts>
void add_summary(TextGrid& grid, const Rows& cells, const Columns& columns, const Counts& counts) {
    std::map<std::pair<std::string, std::string>, Rows> groups;
    for (const ReportCell* cell : cells) groups[{cell->algorithm, cell->table}].push_back(cell);
    for (const auto& [name, rows] : groups) {
        std::vector<GridCell> row = grid_row(name.first, name.second);
        for (const auto count : counts(rows)) row.push_back(grid_cell(count));
        for (const SummaryColumn& column : columns) row.push_back(summary_cell(rows, column));
        grid.rows.push_back(std::move(row));
    }
}

}  // namespace

TextGrid error_summary_grid(const ReportData& data) {
    TextGrid grid = figure_grid("Over all verified cells: sums of counts, worst of the rest",
                                "algorithm|table type|#cells", error_columns);
    add_summary(grid, verified_cells(data), error_columns,
                [](const Rows& rows) { return std::array{rows.size()}; });
    return grid;
}

TextGrid error_grid(const ReportData& data) {
    return cell_grid("Every cell", "scene|shape|algorithm|table type|status", error_columns, data.swept());
}

TextGrid stability_summary_grid(const ReportData& data) {
    TextGrid grid = figure_grid("Over all families: sums of counts, worst of the rest",
                                "algorithm|table type|#families|#failed", stability_columns);
    Rows all;
    for (const ReportCell& row : data.stability) all.push_back(&row);
    add_summary(grid, all, stability_columns, [](const Rows& rows) {
        const auto failed = std::ranges::count_if(rows, [](const ReportCell* row) { return row->failed(); });
        return std::array{rows.size(), static_cast<std::size_t>(failed)};
    });
    return grid;
}

TextGrid stability_grid(const ReportData& data) {
    return cell_grid("Family by family", "family|algorithm|table type|status", stability_columns,
                     data.stability);
}

}  // namespace edgewise::reports
