// SPDX-License-Identifier: MIT
//
// What was counted and what the heap took, of one scene and shape; columns that nothing was counted for are
// left out, the text above the table says why. results.csv has all.
#include <algorithm>

#include "edgewise/reports/tables/cache_tables.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

struct CounterColumn {
    const char* title;
    store::FigureName figure;
};

constexpr CounterColumn counter_columns[] = {
    {"minor faults", "counters.minor_faults"},
    {"major faults", "counters.major_faults"},
    {"context switches", "counters.context_switches"},
    {"migrations", "counters.cpu_migrations"},
    {"instructions", "counters.instructions"},
    {"cycles", "counters.cycles"},
    {"branch misses", "counters.branch_misses"},
    {"L1D fills", "counters.l1d_fills"},
    {"L2 demand misses", "counters.l2_demand_misses"},
    {"LLC misses", "counters.llc_misses"},
    {"dTLB walks", "counters.dtlb_walks"},
    {"table asked for, B", store::FigureName("heap.{structure}.requested_bytes").of("table")},
    {"size classes, B", store::FigureName("heap.{structure}.size_class_bytes").of("table")},
    {"slack, B", store::FigureName("heap.{structure}.slack_bytes").of("table")},
    {"resident, B", store::FigureName("heap.{structure}.resident_bytes").of("table")}};

}  // namespace

TextGrid counters_grid(const ReportData& data) {
    const std::string shape = reference_shape(data);
    std::vector<const ReportCell*> cells;
    for (const ReportCell& cell : data.cells) {
        const bool same_scene = cells.empty() || cells.front()->scene_label == cell.scene_label;
        if (cell.verified() && cell.shape == shape && same_scene) cells.push_back(&cell);
    }
    TextGrid grid{cells.empty() ? "" : cells.front()->scene_label + ", " + shape + ", per query",
                  columns_of("algorithm|table type"),
                  {}};
    std::vector<CounterColumn> shown;
    for (const CounterColumn& column : counter_columns) {
        const auto has = [&](const ReportCell* cell) {
            return cell->figure(column.figure).value.has_value();
        };
        if (std::any_of(cells.begin(), cells.end(), has)) shown.push_back(column);
    }
    for (const CounterColumn& column : shown) grid.columns.push_back({column.title, true});
    for (const ReportCell* cell : cells) {
        std::vector<GridCell> row = {{cell->algorithm}, {cell->table}};
        for (const CounterColumn& column : shown) row.push_back(figure_cell(cell->figure(column.figure)));
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

}  // namespace edgewise::reports
