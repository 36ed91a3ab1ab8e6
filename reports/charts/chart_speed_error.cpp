// SPDX-License-Identifier: MIT
//
// Speed against error: what accuracy a nanosecond buys. Log-log; an error of exactly 0 has no place on a
// logarithmic axis, so it is drawn on a labelled floor one decade or more below the smallest error.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

void speed_error_add_row(const ReportCell& cell, ChartRows& rows) {
    const auto ns = rows.omitted.positive(cell.figure("time.separated_ns"),
                                          "a time of 0 has no place on a logarithmic axis", "time: ");
    if (!ns) return;
    const measure::Figure error = cell.figure("error.worst_error_given");
    if (!error.value) return rows.omitted.add("error: " + error.reason);
    ChartJson row = cell_json(cell);
    row["ns"] = *ns;
    row["error"] = *error.value;
    rows.values.push_back(std::move(row));
}

/// A whole power of ten below every positive error; writes "drawn", the place on the axis, into each row.
double place_on_axis(ChartJson& values) {
    double least = 1e-15;
    for (const ChartJson& row : values)
        if (row["error"] > 0) least = std::min(least, row["error"].get<double>());
    double floor = 1e-15;
    while (floor > least / 10 && floor > 1e-300) floor /= 10;
    for (ChartJson& row : values) row["drawn"] = row["error"] > 0 ? row["error"].get<double>() : floor;
    return floor;
}

/// Even powers of ten among the errors, and the floor where something stands on it. A tick beyond the data
/// would be drawn beside the panel.
ChartJson ticks(const ChartJson& values, double floor) {
    double least = 1e300, largest = 0;
    ChartJson places = ChartJson::array();
    for (const ChartJson& row : values) {
        if (row["error"] == 0 && places.empty()) places.push_back(floor);
        if (row["error"] > 0) least = std::min(least, row["error"].get<double>());
        largest = std::max(largest, row["error"].get<double>());
    }
    for (int power = -300; power <= 300; power += 2) {
        // Read from text: a product of tens would miss the decimal value by a rounding.
        const double place = std::stod(fmt::format("1e{}", power));
        if (place >= (places.empty() ? least : 10 * floor) && place <= largest) places.push_back(place);
    }
    return places;
}

}  // namespace

Chart speed_error_chart(const ReportData& data) {
    Chart chart = chart_of_file("speed_error");
    ChartRows rows;
    for (const ReportCell& cell : data.cells)
        if (cell.verified()) speed_error_add_row(cell, rows);
    if (!take_rows(chart, rows)) return chart;
    ChartJson &values = rows.values, floors = ChartJson::array();
    const double floor = place_on_axis(values);
    const auto zeros =
        std::count_if(values.begin(), values.end(), [](const auto& row) { return row["error"] == 0; });
    if (zeros > 0) {
        floors.push_back(ChartJson::object({{"floor", floor}}));
        chart.notes.push_back(fmt::format(
            "{} of {} points have an error of exactly 0: they stand on the dotted line at the left edge, "
            "whose place on the axis means nothing.",
            zeros, values.size()));
    }
    draw(chart, data, values,
         {{"floors", floors},
          {"ticks", ticks(values, floor)},
          {"tick_label",
           fmt::format("datum.value < {:g} ? 'exactly 0' : format(datum.value, '.0e')", floor * 2)}});
    return chart;
}

}  // namespace edgewise::reports
