// SPDX-License-Identifier: MIT
//
// The error tables. Sums and worst values run over the cells that have the figure; how many lack it is shown.
#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "edgewise/reports/tables.hpp"

namespace edgewise {

namespace {

struct Column {
    const char* title;
    const char* name;
    bool sum;  ///< in the summary: add up, else take the worst
};

constexpr Column columns[] = {{"checked", "checked", true},
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
                              {"cycles", "cycles", true},
                              {"mean steps", "mean_steps", false},
                              {"max steps", "max_steps", false}};

GridCell summary_cell(const std::vector<const ReportCell*>& cells, const Column& column) {
    StoredFigure total{"error", column.name, std::nullopt, "", "", ""};
    std::size_t missing = 0;
    for (const ReportCell* cell : cells) {
        const StoredFigure figure = cell->figure("error", column.name);
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
    if (total.value && missing)
        shown.text += fmt::format(" ({} of {} cells)", cells.size() - missing, cells.size());
    return shown;
}

}  // namespace

Grid error_summary_grid(const ReportData& data) {
    std::map<std::pair<std::string, std::string>, std::vector<const ReportCell*>> groups;
    for (const ReportCell& cell : data.cells)
        if (cell.verified()) groups[{cell.algorithm, cell.table}].push_back(&cell);
    Grid grid{"Over all verified cells: sums of counts, worst of the rest",
              {{"algorithm"}, {"table type"}, {"cells", true}},
              {}};
    for (const Column& column : columns) grid.columns.push_back({column.title, true});
    for (const auto& [name, cells] : groups) {
        std::vector<GridCell> row{{name.first}, {name.second}, {std::to_string(cells.size())}};
        for (const Column& column : columns) row.push_back(summary_cell(cells, column));
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

Grid error_grid(const ReportData& data) {
    Grid grid{"Every cell", {{"scene"}, {"shape"}, {"algorithm"}, {"table type"}, {"status"}}, {}};
    for (const Column& column : columns) grid.columns.push_back({column.title, true});
    for (const ReportCell& cell : data.cells) {
        std::vector<GridCell> row{
            {cell.scene_label}, {cell.shape}, {cell.algorithm}, {cell.table}, {cell.status}};
        for (const Column& column : columns) row.push_back(figure_cell(cell.figure("error", column.name)));
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

}  // namespace edgewise
