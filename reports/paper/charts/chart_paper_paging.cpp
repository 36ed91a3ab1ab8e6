// SPDX-License-Identifier: MIT
//
// Page faults per query against the memory that tables have: measured under limits (points) and predicted by
// the page-granular reuse distance (line), in one plot.
#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/chapter/paging_limits.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

ChartJson fault_row(const ReportCell& cell, double memory, const char* kind, double faults) {
    ChartJson row = curve_json(cell);
    row["memory"] = memory;
    row["kind"] = kind;
    row["faults"] = faults;
    return row;
}

/// A limit's two places on the predicted line, and its measured point.
void add_limit(const ReportCell& cell, const PagingLimit& limit, ChartRows& rows) {
    const double held = limit.held.value.value_or(0), given = limit.limit.value.value_or(0);
    if (held > 0 && limit.predicted_at_held.value)
        rows.values.push_back(fault_row(cell, held, "predicted", *limit.predicted_at_held.value));
    if (given > 0 && limit.predicted_at_limit.value)
        rows.values.push_back(fault_row(cell, given, "predicted", *limit.predicted_at_limit.value));
    if (held > 0 && limit.faults.value)
        rows.values.push_back(fault_row(cell, held, "measured", *limit.faults.value));
    else
        rows.omitted.add(limit.faults.value ? limit.held.reason : limit.faults.reason);
}

}  // namespace

Chart paper_paging_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_thrash_paging");
    if (data.scene_files.empty()) chart.section.clear();
    ChartRows rows;
    bool keeps_recency = true;
    for (const ReportCell& row : data.paging) {
        keeps_recency = keeps_recency && row.figure("paging.keeps_recency").value.value_or(1) != 0;
        for (const PagingLimit& limit : paging_limits(row)) add_limit(row, limit, rows);
    }
    if (!take_rows(chart, rows, "limit")) return chart;
    if (!keeps_recency)
        chart.notes.emplace_back(
            "The system could throw out any page, not the least recent (read-ahead could not be set), so "
            "measured faults need not follow the line.");
    draw(chart, data, rows.values);
    return chart;
}

}  // namespace edgewise::reports
