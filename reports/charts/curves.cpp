// SPDX-License-Identifier: MIT
//
// See curves.hpp.
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

ChartJson timed_row(const ReportCell& cell, const store::QueryTime& time, Omissions& omitted) {
    const measure::Figure ns = cell.figure(time.ns);
    if (!cell.verified() || !ns.value || *ns.value <= 0) {
        omitted.add(!cell.verified() ? fmt::format("the cell is {}: {}", cell.status, cell.reason)
                    : ns.value       ? "a time of 0"
                                     : ns.reason);
        return nullptr;
    }
    ChartJson row = curve_json(cell);
    row["ns"] = *ns.value;
    const measure::Figure low = cell.figure(time.low), high = cell.figure(time.high);
    row["low"] = low.value && *low.value > 0 ? *low.value : *ns.value;
    row["high"] = high.value && *high.value > 0 ? *high.value : *ns.value;
    return row;
}

}  // namespace edgewise::reports
