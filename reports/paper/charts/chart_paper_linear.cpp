// SPDX-License-Identifier: MIT
//
// Figure 4 of the paper: time a query against linear speed, bodies of 8 vertices. What coherence knows of a
// speed is the way a step over the size of the body: that is the axis; speeds in metres a second follow from
// a time step and a size, which the paper does not name.
#include <algorithm>

#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

constexpr double short_step = 1.0 / 60, long_step = 0.5;  ///< seconds

ChartJson values_of(const StoredScene& scene, Omissions& omitted) {
    ChartJson values = ChartJson::array();
    for (const ReportCell* cell : scene.cells) {
        const auto way = scene_number(*cell, "step_in_dimensions");
        if (!way) continue;
        ChartJson row = timed_row(*cell, store::all_time, omitted);
        if (row.is_null()) continue;
        row["step_in_dimensions"] = *way;
        row["m_s_at_60_Hz"] = *way / short_step;
        row["m_s_at_2_Hz"] = *way / long_step;
        values.push_back(std::move(row));
    }
    return values;
}

Curves curves_of(double most) {
    Curves curves;
    curves.x = {"step_in_dimensions", "way a step, of the body's smallest dimension", scale_with_zero(0.005),
                ticks_at({0, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5})};
    curves.y = {"ns", "ns a query, median", scale_up_to(most)};
    curves.also = {"m_s_at_60_Hz", "m_s_at_2_Hz"};
    // Their axis ends at 1.5 m/s: beyond half a dimension a step at half a second, which is their own limit.
    for (const auto& layer :
         span_layers(curves.x, 0.1 * short_step, 1.5 * short_step, 0, "paper's axis, 60 steps a second"))
        curves.behind.push_back(layer);
    for (const auto& layer : span_layers(curves.x, 0.1 * long_step, 0.5, 1, "paper's axis, 2 steps a second"))
        curves.behind.push_back(layer);
    return curves;
}

}  // namespace

Chart paper_linear_chart(const ReportData& data) {
    Chart chart{
        "paper_figure_4",
        "Figure 4: time against linear speed (8 vertices)",
        "Each line is an algorithm on a table type: median time of all queries, separated and overlapping as "
        "they come, with its 95 % interval, against the way that a body moves in a step, as a share of its "
        "smallest dimension (the paper's own limit is a half). The paper's axis goes from 0.1 to 1.5 m/s and "
        "up to 3e-5 s; it reports V-Clip clearly faster. It names neither time step nor size of the body: "
        "the "
        "grey bars show where its axis lies for a body one metre wide at 60 and at 2 steps a second, and the "
        "tooltip gives both speeds.",
        nullptr,
        {},
        {},
        dynamic_section};
    Omissions omitted;
    const ChartJson values = values_of(scene_file(data, "paper_linear_8"), omitted);
    if (values.empty()) return chart;
    omitted.write("cell", chart.notes);
    double most = 0;
    for (const ChartJson& row : values) most = std::max(most, row["high"].get<double>());
    chart.spec = curve_spec(data, values, curves_of(most));
    chart.fallback = data_grid(values, {"step_in_dimensions", "m_s_at_60_Hz", "m_s_at_2_Hz", "algorithm",
                                        "table", "ns", "low", "high"});
    return chart;
}

}  // namespace edgewise::reports
