// SPDX-License-Identifier: MIT
//
// Misses per query against the size of a cache, from exact reuse distances: one line per algorithm and table
// type, a row of panels per scene; lines of 64 bytes left, pages of 4 KiB right.
#include <cmath>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/cache_tables.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

ChartJson misses_values_of(const ReportData& data) {
    ChartJson values = ChartJson::array();
    for (const ReportCell* cell : modelled_cells(data)) {
        for (const store::FigureRow& figure : cell->figures) {
            for (const store::ReuseNames& family : store::reuse_names) {
                const auto power = family.misses.value_in(figure.probe, figure.name);
                if (!power || !figure.value) continue;
                ChartJson row = cell_json(*cell);
                row["unit"] = family.units;
                row["bytes"] = std::ldexp(1.0, std::stoi(*power));
                row["misses"] = *figure.value;
                values.push_back(std::move(row));
            }
        }
    }
    return values;
}

}  // namespace

Chart misses_chart(const ReportData& data) {
    Chart chart = chart_of_file("misses");
    ChartJson values = misses_values_of(data);
    if (take_rows(chart, values)) draw(chart, data, values);
    return chart;
}

}  // namespace edgewise::reports
