// SPDX-License-Identifier: MIT
//
// A chart of curves over one number of a scene: one curve an algorithm x table type, with its interval behind
// it. Colour is the layout, dash what else makes the table type (precision, further axes), point shape the
// algorithm. What stands behind the curves (a paper's figures, a cache's size) is given as layers of its own.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"

namespace edgewise::reports {

/// An axis of numbers.
struct CurveAxis {
    std::string field, title;
    ChartJson scale, axis = nullptr;  ///< null: the default
};

struct Curves {
    CurveAxis x, y;
    bool has_interval = true;               ///< rows have `low` and `high`
    std::vector<std::string> also = {};     ///< further numbers of the tooltip
    ChartJson behind = ChartJson::array();  ///< layers with data of their own
    int width = 640, height = 320;
};

/// What names a cell among curves: cell_json, and `variant`, `point`, `stroke`. A row that sets `unjoined`
/// is a point that no line goes through; one that sets `apart` is a larger one.
[[nodiscard]] ChartJson curve_json(const ReportCell& cell);
/// A row with a time and its interval in `y`, `low`, `high`; null, and counted, when it was not measured.
[[nodiscard]] ChartJson timed_row(const ReportCell& cell, const store::QueryTime& time, Omissions& omitted);
/// The layers, without data: for one panel, or as the `spec` of facets.
[[nodiscard]] ChartJson curve_layers(const ReportData& data, const ChartJson& values, const Curves& curves);
/// A whole specification of one panel.
[[nodiscard]] ChartJson curve_spec(const ReportData& data, const ChartJson& values, const Curves& curves);
/// One number as an encoding.
[[nodiscard]] ChartJson curve_axis(const CurveAxis& axis);
/// A logarithmic scale near 0 that has a place for 0: linear below `constant`.
[[nodiscard]] ChartJson scale_with_zero(double constant);
/// Ticks at these places.
[[nodiscard]] ChartJson ticks_at(const std::vector<double>& places);
/// From 0 on, to the data's end.
[[nodiscard]] ChartJson scale_from_zero();
/// From 0 to this and a little more: room for the bars at the top.
[[nodiscard]] ChartJson scale_up_to(double most);
/// Sizes as powers of two, labelled in KiB, MiB, GiB.
[[nodiscard]] CurveAxis bytes_axis(const std::string& field, const std::string& title);
/// A labelled bar along x in the panel's top row `row` (0 first): "the paper's axis".
[[nodiscard]] std::vector<ChartJson> span_layers(const CurveAxis& x, double from, double to, int row,
                                                 const std::string& label);

}  // namespace edgewise::reports
