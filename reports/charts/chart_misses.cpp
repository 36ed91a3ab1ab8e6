// SPDX-License-Identifier: MIT
//
// Misses per query against the size of a cache, from exact reuse distances: one line per algorithm and table
// type, a row of panels per scene; lines of 64 bytes left, pages of 4 KiB right.
#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/cache_tables.hpp"

namespace edgewise::reports {

Chart misses_chart(const ReportData& data) {
    ChartRows rows;
    for (const ReportCell* cell : modelled_cells(data)) add_misses(*cell, cell_json(*cell), rows.values);
    return drawn_chart(chart_of_file("misses"), data, std::move(rows));
}

}  // namespace edgewise::reports
