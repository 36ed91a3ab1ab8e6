// SPDX-License-Identifier: MIT
//
// See page.hpp. Failures stand before everything else; what is long is folded.
#include "edgewise/reports/page.hpp"

#include <fmt/core.h>

#include "edgewise/reports/bundles.hpp"
#include "edgewise/reports/cache_tables.hpp"
#include "edgewise/reports/page_shell.hpp"
#include "edgewise/reports/tables.hpp"
#include "edgewise/reports/text.hpp"

namespace edgewise {

namespace {

std::string paragraph(const std::string& text, const std::string& style = {}) {
    return fmt::format("<p{}>{}</p>\n", style.empty() ? "" : " class=\"" + style + "\"", html_text(text));
}

std::string heading(const std::string& id, const std::string& text) {
    return fmt::format("<h2 id=\"{}\">{}</h2>\n", id, html_text(text));
}

std::string folded(const std::string& summary, const std::string& inside) {
    return fmt::format("<details><summary>{}</summary>\n{}</details>\n", html_text(summary), inside);
}

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
    std::string out = "<h1>Edgewise report</h1>\n" + paragraph(report_purpose());
    out += paragraph(verdict_line(data), failed ? "verdict bad" : partly ? "verdict part" : "verdict");
    if (failed || partly) {
        out += heading("problems", failed ? "Failed and unavailable cells" : "Unavailable cells");
        out += grid_html(problems_grid(data));
    }
    out +=
        "<nav><a href=\"#machine\">Machine and build</a><a href=\"#charts\">Charts</a><a "
        "href=\"#bytes\">Bytes "
        "per edge</a><a href=\"#layouts\">Layouts</a><a href=\"#caches\">Caches</a><a "
        "href=\"#counters\">Counters</a><a "
        "href=\"#times\">Times</a><a "
        "href=\"#errors\">Errors</a><a "
        "href=\"#stability\">Stability</a><a href=\"#cells\">All "
        "cells</a></nav>\n";
    out += heading("machine", "Machine and build");
    out += "<div class=\"facts\">\n" + grid_html(facts_grid(data)) + "</div>\n<h3>Scenes</h3>\n";
    return out + grid_html(scenes_grid(data));
}

std::string picture_html(const Chart& chart, const StaticFigures& figures) {
    const auto svg = figures.svg.find(chart.name);
    return svg != figures.svg.end() ? svg->second : grid_html(chart.fallback);
}

std::string chart_html(const Chart& chart, const StaticFigures& figures, bool alive) {
    std::string out = fmt::format("<h3>{}</h3>\n", html_text(chart.title)) + paragraph(chart.how_to_read);
    if (chart.spec.is_null()) {
        out += paragraph("Nothing to draw: no cell has the figures of this chart.", "note");
    } else {
        out += fmt::format("<div class=\"chart\"><div id=\"chart-{}\">\n{}</div></div>\n", chart.name,
                           picture_html(chart, figures));
        if (alive)
            out += fmt::format(
                "<script type=\"application/json\" data-chart=\"{}\">{}</script>\n", chart.name,
                inline_json(chart.spec.dump(-1, ' ', false, ChartJson::error_handler_t::replace)));
    }
    for (const std::string& note : chart.notes) out += paragraph(note, "note");
    return out;
}

std::string charts_html(const std::vector<Chart>& charts, const StaticFigures& figures, bool alive) {
    std::string out = heading("charts", "Charts");
    if (!alive)
        out += paragraph(
            "The chart bundles were not available when this report was written (they are fetched with npm at "
            "set-up), so the charts are missing: the tables hold the same figures.",
            "verdict part");
    if (!figures.note.empty()) out += paragraph(figures.note, "note");
    for (const Chart& chart : charts) out += chart_html(chart, figures, alive);
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
        all += folded(fmt::format("{}, {} pairs, all shapes ({})", scene, pair_name(kind),
                                  plural(grid.rows.size(), "cell")),
                      grid_html(grid));
    }
    return shown + all;
}

std::string times_html(const ReportData& data) {
    std::string out = heading("times", "Times") + paragraph(time_explanation());
    for (const std::string& scene : scene_labels(data))
        out += "<h3>" + html_text(scene) + "</h3>\n" + scene_times_html(data, scene);
    return out;
}

std::string stability_html(const ReportData& data) {
    std::string out = heading("stability", "Stability") + paragraph(stability_explanation(data));
    if (data.stability.empty()) return out;
    return out + grid_html(stability_summary_grid(data)) +
           folded(fmt::format("Every family ({})", plural(data.stability.size(), "row")),
                  grid_html(stability_grid(data)));
}

std::string layouts_html(const ReportData& data) {
    std::string out = heading("layouts", "What layouts cost") + paragraph(layout_explanation());
    out += grid_html(layout_cost_grid(data));
    const TextGrid memory = scene_memory_grid(data);
    if (!memory.rows.empty()) out += grid_html(memory);
    std::string pictures;
    for (const Drawing& drawing : drawings(data))
        pictures += "<div class=\"chart\">" + drawing.svg + "</div>\n";
    return pictures.empty() ? out
                            : out + folded("The layouts draw themselves: the table of a cube", pictures);
}

std::string caches_html(const ReportData& data) {
    std::string out = heading("caches", "Caches") + paragraph(cache_explanation(data));
    if (modelled_cells(data).empty()) return out;
    out += grid_html(misses_grid(data)) + grid_html(working_sets_grid(data)) + grid_html(policy_grid(data));
    for (const std::string& machine : modelled_machines(data)) {
        std::string inside = grid_html(causes_grid(data, machine));
        for (const std::string& level : broken_down_levels(data, machine)) {
            for (const char* by : {"field.", "step."})
                inside += grid_html(breakdown_grid(data, machine, level, by));
        }
        out += folded(machine + ": why, what and where", inside);
    }
    return out;
}

std::string tables_html(const ReportData& data) {
    const std::string shape = reference_shape(data);
    std::string out = heading("bytes", "Bytes per edge") + paragraph(bytes_explanation());
    out += "<h3>" + html_text(shape) + "</h3>\n" + grid_html(bytes_grid(data, shape));
    out += folded("All shapes", grid_html(bytes_grid(data, "")));
    out += layouts_html(data);
    out += caches_html(data);
    out += heading("counters", "Counters and heap") + paragraph(counter_explanation(data)) +
           grid_html(counters_grid(data));
    out += times_html(data);
    out += heading("errors", "Errors") + paragraph(error_explanation()) + grid_html(error_summary_grid(data));
    out += folded(fmt::format("Every cell ({})", data.cells.size()), grid_html(error_grid(data)));
    out += stability_html(data);
    out += heading("cells", "All cells");
    out += paragraph(
        "results.csv beside this page holds every figure of every cell; report.md holds these tables as "
        "Markdown; figures/ holds the charts' specifications and, where node was at hand, their pictures.");
    return out +
           folded(fmt::format("All {}", plural(data.cells.size(), "cell")), grid_html(cells_grid(data)));
}

}  // namespace

std::string page_html(const ReportData& data, const std::vector<Chart>& charts, const StaticFigures& figures,
                      const std::string& scripts) {
    const bool alive = !scripts.empty();
    std::string out =
        head_html() + opening_html(data) + charts_html(charts, figures, alive) + tables_html(data);
    out += "</main>\n";
    if (alive) out += scripts + "<script>" + page_script + "</script>\n";
    return out + "</body>\n</html>\n";
}

}  // namespace edgewise
