// SPDX-License-Identifier: MIT
//
// See paper_charts.hpp.
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

std::vector<Chart> chapter_charts(const ReportData& data) {
    std::vector<Chart> charts = {paper_linear_chart(data),     paper_angular_chart(data, 6),
                                 paper_angular_chart(data, 7), paper_angular_chart(data, 8),
                                 paper_bodies_chart(data),     paper_complexity_chart(data),
                                 paper_misses_chart(data),     paper_reuse_chart(data),
                                 paper_paging_chart(data),     paper_here_chart(data)};
    for (Chart& chart : own_scene_charts(data)) charts.push_back(std::move(chart));
    std::erase_if(charts, [](const Chart& chart) { return chart.spec.is_null(); });
    return charts;
}

}  // namespace edgewise::reports
