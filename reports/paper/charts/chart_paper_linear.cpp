// SPDX-License-Identifier: MIT
//
// Figure 4 of the paper: time per query against linear speed, bodies of 8 vertices. What coherence knows of a
// speed is the displacement per step divided by the size of the body: that is the axis; speeds in metres per
// second follow from a time step and a size, which the paper does not name.
#include <algorithm>

#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

constexpr double short_step = 1.0 / 60, long_step = 0.5;  ///< seconds

ChartJson linear_values_of(const StoredScene& scene, Omissions& omitted) {
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

}  // namespace

Chart paper_linear_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_linear");
    chart.name = "paper_figure_4";
    Omissions omitted;
    ChartJson values = linear_values_of(scene_file(data, "paper_linear_8"), omitted);
    if (!take_rows(chart, values, omitted)) return chart;
    double most = 0;
    for (const ChartJson& row : values) most = std::max(most, row["high"].get<double>());
    draw(chart, data, values, {{"most", 1.15 * most}});
    return chart;
}

}  // namespace edgewise::reports
