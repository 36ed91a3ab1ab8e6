// SPDX-License-Identifier: MIT
//
// The page. Failures stand before everything else; what is long is folded. Its frame is page.html, by whose
// policy nothing is loaded from anywhere: scripts and styles only as they stand in the page, no eval. The
// fallback inside each chart's element stays until page.js has drawn it, and comes back when that fails.
#include "edgewise/reports/page/page.hpp"

#include <fmt/core.h>

#include "edgewise/reports/page/bundles.hpp"
#include "edgewise/reports/page/chapters.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

/// What is drawn, and how.
struct PageCharts {
    const std::vector<Chart>& all;
    const StaticPictures& pictures;
    bool alive;  ///< with their specifications for the scripts
};

/// `style` is a class of the style sheet, or empty.
std::string html_paragraph(const std::string& text, const std::string& style = {}) {
    return fmt::format("<p{}>{}</p>\n", style.empty() ? "" : " class=\"" + style + "\"", html_text(text));
}

/// A chapter's heading, with the name that links use.
std::string html_heading(const std::string& id, const std::string& text) {
    return fmt::format("<h2 id=\"{}\">{}</h2>\n", id, html_text(text));
}

/// Title, words, picture or fallback, notes; `level`: of its heading, such as "h3".
std::string html_chart(const Chart& chart, const PageCharts& charts, const std::string& level) {
    std::string out = fmt::format("<{0}>{1}</{0}>\n", level, html_text(chart.title));
    out += html_paragraph(chart.how_to_read);
    if (chart.spec.is_null()) {
        out += html_paragraph("Nothing to draw: no cell has the figures of this chart.", "note");
    } else {
        const auto svg = charts.pictures.svg.find(chart.name);
        out += fmt::format("<div class=\"chart\"><div id=\"chart-{}\">\n{}</div></div>\n", chart.name,
                           svg != charts.pictures.svg.end() ? svg->second : grid_html(chart.fallback));
        if (charts.alive)
            out += fmt::format("<script type=\"application/json\" data-chart=\"{}\">{}</script>\n",
                               chart.name, inline_json(spec_text(chart)));
    }
    for (const std::string& note : chart.notes) out += html_paragraph(note, "note");
    return out;
}

std::string charts_html(const PageCharts& charts, const std::string& section, const std::string& level) {
    std::string out;
    for (const Chart& chart : charts.all)
        if (chart.section == section) out += html_chart(chart, charts, level);
    return out;
}

std::string opening_html(const ReportData& data, const std::vector<Chapter>& chapters) {
    const bool failed = data.any_failed(), partly = data.count("unavailable") > 0;
    std::string out = "<h1>Edgewise report</h1>\n" + html_paragraph(prose("purpose.md"));
    out += html_paragraph(verdict_line(data), failed ? "verdict bad" : partly ? "verdict part" : "verdict");
    if (failed || partly) {
        out += html_heading("problems", failed ? "Failed and unavailable cells" : "Unavailable cells");
        out += grid_html(problems_grid(data));
    }
    out += "<nav><a href=\"#machine\">Machine and build</a><a href=\"#charts\">Charts</a>";
    for (const Chapter& chapter : chapters)
        out += fmt::format("<a href=\"#{}\">{}</a>", chapter.id,
                           html_text(chapter.link.empty() ? chapter.title : chapter.link));
    out += "</nav>\n";
    out += html_heading("machine", "Machine and build");
    out += "<div class=\"facts\">\n" + grid_html(facts_grid(data)) + "</div>\n<h3>Scenes</h3>\n";
    return out + grid_html(scenes_grid(data));
}

std::string block_html(const ChapterBlock& block, const PageCharts& charts) {
    std::string out = block.title.empty() ? "" : "<h3>" + html_text(block.title) + "</h3>\n";
    if (!block.paragraph.empty()) out += html_paragraph(block.paragraph);
    if (!block.section.empty()) out += charts_html(charts, block.section, "h4");
    out += block.elements;
    for (const TextGrid& grid : block.grids) out += grid_html(grid);
    if (block.fold.empty()) return out;
    return fmt::format("<details><summary>{}</summary>\n{}</details>\n", html_text(block.fold), out);
}

std::string chapter_html(const Chapter& chapter, const PageCharts& charts) {
    std::string out = html_heading(chapter.id, chapter.title);
    if (!chapter.paragraph.empty()) out += html_paragraph(chapter.paragraph);
    for (const ChapterBlock& block : chapter.blocks) out += block_html(block, charts);
    return out;
}

}  // namespace

std::string verdict_line(const ReportData& data) {
    const std::size_t failed = data.count("failed"), unavailable = data.count("unavailable");
    std::string line = plural(data.count("verified"), "cell");
    if (failed == 0 && unavailable == 0)
        line = fmt::format("All {} verified.", line);
    else
        line = fmt::format("{} verified, {} failed, {} unavailable.", line, failed, unavailable);
    if (data.cell_count() == 0) line = "No cells.";
    if (data.stability.empty()) return line;
    std::size_t failed_rows = 0;
    for (const ReportCell& row : data.stability) failed_rows += row.status == "failed";
    return line +
           fmt::format(" Of {}, {} failed.", plural(data.stability.size(), "stability row"), failed_rows);
}

std::string page_html(const ReportData& data, const std::vector<Chart>& all, const StaticPictures& pictures,
                      const std::string& scripts) {
    const PageCharts charts{all, pictures, !scripts.empty()};
    const std::vector<Chapter> chapters = report_chapters(data, all);
    std::string out = opening_html(data, chapters) + html_heading("charts", "Charts");
    if (!charts.alive) out += html_paragraph(prose("no_bundles.md"), "verdict part");
    if (!pictures.note.empty()) out += html_paragraph(pictures.note, "note");
    out += charts_html(charts, "", "h3");
    for (const Chapter& chapter : chapters) out += chapter_html(chapter, charts);
    const std::string page_script = fmt::format("<script>\n{}</script>\n", report_text("page.js"));
    return fmt::format(fmt::runtime(report_text("page.html")), fmt::arg("style", report_text("page.css")),
                       fmt::arg("chapters", out),
                       fmt::arg("scripts", charts.alive ? scripts + page_script : ""));
}

}  // namespace edgewise::reports
