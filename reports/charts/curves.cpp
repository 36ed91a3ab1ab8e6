// SPDX-License-Identifier: MIT
#include "edgewise/reports/charts/curves.hpp"

#include <fmt/core.h>

namespace edgewise::reports {

ChartJson curve_json(const ReportCell& cell) {
    ChartJson row = cell_json(cell);
    row["scene"] = cell.scene;
    row["variant"] = cell.axes.empty() ? cell.precision : cell.precision + " " + cell.axes;
    row["point"] = cell.algorithm;
    row["stroke"] = cell.algorithm + " " + cell.table;
    return row;
}

ChartJson timed_row(const ReportCell& cell, Omissions& omitted) {
    if (!cell.verified()) {
        omitted.add(fmt::format("the cell is {}: {}", cell.status, cell.reason));
        return nullptr;
    }
    if (!omitted.positive(cell.figure(store::all_time.ns), "a time of 0")) return nullptr;
    ChartJson row = curve_json(cell);
    add_time(row, cell, store::all_time);
    return row;
}

}  // namespace edgewise::reports
