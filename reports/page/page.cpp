// SPDX-License-Identifier: MIT
//
// See page.hpp. Failures stand before everything else; what is long is folded.
#include "edgewise/reports/page/page.hpp"

#include <fmt/core.h>

#include "edgewise/reports/page/page_parts.hpp"
#include "edgewise/reports/page/page_shell.hpp"
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/tables/cache_tables.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/tables/text.hpp"

namespace edgewise::reports {

namespace {

std::string head_html() {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>Edgewise report</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n",
        page_policy, page_style);
}

std::string opening_html(const ReportData& data) {
    const bool failed = data.any_failed(), partly = data.count("unavailable") > 0;
    std::string out = "<h1>Edgewise report</h1>\n" + html_paragraph(report_purpose());
    out += html_paragraph(verdict_line(data), failed ? "verdict bad" : partly ? "verdict part" : "verdict");
    if (failed || partly) {
        out += html_heading("problems", failed ? "Failed and unavailable cells" : "Unavailable cells");
        out += grid_html(problems_grid(data));
    }
    out += "<nav><a href=\"#machine\">Machine and build</a><a href=\"#charts\">Charts</a>";
    if (has_paper_chapter(data)) out += "<a href=\"#paper\">" + html_text(paper_chapter_title(data)) + "</a>";
    out +=
        "<a "
        "href=\"#bytes\">Bytes "
        "per edge</a><a href=\"#layouts\">Layouts</a><a href=\"#caches\">Caches</a><a "
        "href=\"#counters\">Counters</a><a "
        "href=\"#times\">Times</a><a "
        "href=\"#errors\">Errors</a><a "
        "href=\"#stability\">Stability</a><a href=\"#cells\">All "
        "cells</a></nav>\n";
    out += html_heading("machine", "Machine and build");
    out += "<div class=\"facts\">\n" + grid_html(facts_grid(data)) + "</div>\n<h3>Scenes</h3>\n";
    return out + grid_html(scenes_grid(data));
}

std::string charts_html(const std::vector<Chart>& charts, const StaticFigures& figures, bool alive) {
    std::string out = html_heading("charts", "Charts");
    if (!alive)
        out += html_paragraph(
            "The chart bundles were not available when this report was written (they are fetched with npm at "
            "set-up), so the charts are missing: the tables hold the same figures.",
            "verdict part");
    if (!figures.note.empty()) out += html_paragraph(figures.note, "note");
    for (const Chart& chart : charts)
        if (chart.section.empty()) out += html_chart(chart, figures, alive, "h3");
    return out;
}

/// The reference shape in full view, all shapes folded.
std::string scene_times_html(const ReportData& data, const std::string& scene) {
    std::string shown, all;
    for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping}) {
        const TextGrid grid = time_grid(data, scene, kind, "");
        if (grid.rows.empty()) continue;
        const TextGrid reference = time_grid(data, scene, kind, reference_shape(data));
        if (!reference.rows.empty()) shown += grid_html(reference);
        all += html_folded(fmt::format("{}, {} pairs, all shapes ({})", scene, pair_name(kind),
                                       plural(grid.rows.size(), "cell")),
                           grid_html(grid));
    }
    return shown + all;
}

std::string times_html(const ReportData& data) {
    std::string out = html_heading("times", "Times") + html_paragraph(time_explanation());
    for (const std::string& scene : scene_labels(data))
        out += "<h3>" + html_text(scene) + "</h3>\n" + scene_times_html(data, scene);
    return out;
}

std::string stability_html(const ReportData& data) {
    std::string out = html_heading("stability", "Stability") + html_paragraph(stability_explanation(data));
    if (data.stability.empty()) return out;
    return out + grid_html(stability_summary_grid(data)) +
           html_folded(fmt::format("Every family ({})", plural(data.stability.size(), "row")),
                       grid_html(stability_grid(data)));
}

std::string layouts_html(const ReportData& data) {
    std::string out = html_heading("layouts", "What layouts cost") + html_paragraph(layout_explanation());
    out += grid_html(layout_cost_grid(data));
    const TextGrid memory = scene_memory_grid(data);
    if (!memory.rows.empty()) out += grid_html(memory);
    std::string pictures;
    for (const Drawing& drawing : drawings(data))
        pictures += "<div class=\"chart\">" + drawing.svg + "</div>\n";
    return pictures.empty() ? out
                            : out + html_folded("The layouts draw themselves: the table of a cube", pictures);
}

std::string caches_html(const ReportData& data) {
    std::string out = html_heading("caches", "Caches") + html_paragraph(cache_explanation(data));
    if (modelled_cells(data).empty()) return out;
    out += grid_html(misses_grid(data)) + grid_html(working_sets_grid(data)) + grid_html(policy_grid(data));
    for (const std::string& machine : modelled_machines(data)) {
        std::string inside = grid_html(causes_grid(data, machine));
        for (const std::string& level : broken_down_levels(data, machine)) {
            for (const store::FigureName& by : {misses_by_field, misses_by_step})
                inside += grid_html(breakdown_grid(data, machine, level, by));
        }
        out += html_folded(machine + ": why, what and where", inside);
    }
    return out;
}

std::string tables_html(const ReportData& data) {
    const std::string shape = reference_shape(data);
    std::string out = html_heading("bytes", "Bytes per edge") + html_paragraph(bytes_explanation());
    out += "<h3>" + html_text(shape) + "</h3>\n" + grid_html(bytes_grid(data, shape));
    out += html_folded("All shapes", grid_html(bytes_grid(data, "")));
    out += layouts_html(data);
    out += caches_html(data);
    out += html_heading("counters", "Counters and heap") + html_paragraph(counter_explanation(data)) +
           grid_html(counters_grid(data));
    out += times_html(data);
    out += html_heading("errors", "Errors") + html_paragraph(error_explanation()) +
           grid_html(error_summary_grid(data));
    out += html_folded(fmt::format("Every cell ({})", data.cells.size()), grid_html(error_grid(data)));
    out += stability_html(data);
    out += html_heading("cells", "All cells");
    out += html_paragraph(
        "results.csv beside this page holds every figure of every cell; report.md holds these tables as "
        "Markdown; figures/ holds the charts' specifications and, where node was at hand, their pictures.");
    return out +
           html_folded(fmt::format("All {}", plural(data.cells.size(), "cell")), grid_html(cells_grid(data)));
}

}  // namespace

std::string page_html(const ReportData& data, const std::vector<Chart>& charts, const StaticFigures& figures,
                      const std::string& scripts) {
    const bool alive = !scripts.empty();
    std::string out = head_html() + opening_html(data) + charts_html(charts, figures, alive);
    out += paper_chapter_html(data, charts, figures, alive) + tables_html(data);
    out += "</main>\n";
    if (alive) out += scripts + "<script>" + page_script + "</script>\n";
    return out + "</body>\n</html>\n";
}

}  // namespace edgewise::reports
