// SPDX-License-Identifier: MIT
//
// See markdown.hpp. Pictures are linked, where there are any.
#include "edgewise/reports/page/markdown.hpp"

#include <fmt/core.h>

#include "edgewise/reports/page/page.hpp"
#include "edgewise/reports/page/page_parts.hpp"
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/tables/cache_tables.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/tables/text.hpp"

namespace edgewise::reports {

namespace {

std::string section(const std::string& title, const std::string& words = {}) {
    return fmt::format("## {}\n\n{}", title, words.empty() ? "" : words + "\n\n");
}

std::string charts_markdown(const std::vector<Chart>& charts, const StaticFigures& figures) {
    std::string out = section("Charts");
    if (!figures.note.empty()) out += figures.note + "\n\n";
    for (const Chart& chart : charts)
        if (chart.section.empty()) out += markdown_chart(chart, figures, "###");
    return out;
}

std::string caches_markdown(const ReportData& data) {
    std::string out = section("Caches", cache_explanation(data));
    if (modelled_cells(data).empty()) return out;
    out += grid_markdown(misses_grid(data)) + grid_markdown(working_sets_grid(data));
    out += grid_markdown(policy_grid(data));
    for (const std::string& machine : modelled_machines(data)) {
        out += grid_markdown(causes_grid(data, machine));
        for (const std::string& level : broken_down_levels(data, machine)) {
            for (const store::FigureName& by : {misses_by_field, misses_by_step})
                out += grid_markdown(breakdown_grid(data, machine, level, by));
        }
    }
    return out;
}

std::string times_markdown(const ReportData& data) {
    std::string out = section("Times", time_explanation());
    for (const std::string& scene : scene_labels(data))
        for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping}) {
            const TextGrid grid = time_grid(data, scene, kind, "");
            if (!grid.rows.empty()) out += grid_markdown(grid);
        }
    return out;
}

}  // namespace

std::string report_markdown(const ReportData& data, const std::vector<Chart>& charts,
                            const StaticFigures& figures) {
    std::string out =
        fmt::format("# Edgewise report\n\n{}\n\n**{}**\n\n", report_purpose(), verdict_line(data));
    const TextGrid problems = problems_grid(data);
    if (!problems.rows.empty()) out += section("Failed and unavailable cells") + grid_markdown(problems);
    out += section("Machine and build") + grid_markdown(facts_grid(data)) + grid_markdown(scenes_grid(data));
    out += charts_markdown(charts, figures) + paper_chapter_markdown(data, charts, figures);
    out += section("Bytes per edge", bytes_explanation()) + grid_markdown(bytes_grid(data, ""));
    out += section("What layouts cost", layout_explanation()) + grid_markdown(layout_cost_grid(data));
    const TextGrid memory = scene_memory_grid(data);
    if (!memory.rows.empty()) out += grid_markdown(memory);
    out += caches_markdown(data);
    out += section("Counters and heap", counter_explanation(data)) + grid_markdown(counters_grid(data));
    out += times_markdown(data);
    out += section("Errors", error_explanation()) + grid_markdown(error_summary_grid(data));
    out += grid_markdown(error_grid(data));
    out += section("Stability", stability_explanation(data));
    if (!data.stability.empty())
        out += grid_markdown(stability_summary_grid(data)) + grid_markdown(stability_grid(data));
    return out + section("All cells") + grid_markdown(cells_grid(data));
}

}  // namespace edgewise::reports
