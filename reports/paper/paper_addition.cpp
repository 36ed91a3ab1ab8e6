// SPDX-License-Identifier: MIT
//
// What this folder adds to the report and to the program.
#include "edgewise/reports/additions.hpp"
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/paper/claims/claims.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

/// Ways to reach the paper's 168 bytes per edge, which it gives as a sum without terms.
nlohmann::json decompositions() { return nlohmann::json::parse(report_text("decompositions.json")); }

/// Returns a table of ways to reach 168 bytes per edge, and the reading that this program uses.
std::string decompositions_text() {
    return rows_text(decompositions(),
                     "ways to 168 bytes per edge = terms|#double = f64|#single = f32| = remark")
        .append(report_text("decompositions.md"));
}

}  // namespace

std::vector<Chart> chapter_charts(const ReportData& data) {
    std::vector<Chart> charts = {
        paper_region_chart(data),     paper_realised_chart(data),   paper_linear_chart(data),
        paper_angular_chart(data, 6), paper_angular_chart(data, 7), paper_angular_chart(data, 8),
        paper_bodies_chart(data),     paper_complexity_chart(data), paper_misses_chart(data),
        paper_reuse_chart(data),      paper_paging_chart(data),     paper_here_chart(data)};
    for (Chart& chart : own_scene_charts(data)) charts.push_back(std::move(chart));
    std::erase_if(charts, [](const Chart& chart) { return chart.spec.is_null(); });
    return charts;
}

Addition paper_addition();
Addition paper_addition() {
    return {.charts = chapter_charts,
            .chapters = paper_chapters,
            .claims_text = claims_text,
            .claims_record = claims_record,
            .decompositions = decompositions,
            .decompositions_text = decompositions_text};
}

}  // namespace edgewise::reports
