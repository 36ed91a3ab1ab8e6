// SPDX-License-Identifier: MIT
//
// See page.hpp. Failures stand before everything else; what is long is folded.
#include "edgewise/reports/page/page.hpp"

#include <fmt/core.h>

#include "edgewise/reports/page/chapters.hpp"
#include "edgewise/reports/page/page_parts.hpp"
#include "edgewise/reports/page/page_shell.hpp"
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"

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

std::string opening_html(const ReportData& data, const std::vector<Chapter>& chapters) {
    const bool failed = data.any_failed(), partly = data.count("unavailable") > 0;
    std::string out = "<h1>Edgewise report</h1>\n" + html_paragraph(prose("purpose.md"));
    out += html_paragraph(verdict_line(data), failed ? "verdict bad" : partly ? "verdict part" : "verdict");
    if (failed || partly) {
        out += html_heading("problems", failed ? "Failed and unavailable cells" : "Unavailable cells");
        out += grid_html(problems_grid(data));
    }
    out += "<nav><a href=\"#machine\">Machine and build</a><a href=\"#charts\">Charts</a>";
    if (has_paper_chapter(data)) out += "<a href=\"#paper\">" + html_text(paper_chapter_title(data)) + "</a>";
    for (const Chapter& chapter : chapters)
        out += fmt::format("<a href=\"#{}\">{}</a>", chapter.id,
                           chapter.link.empty() ? chapter.title : chapter.link);
    out += "</nav>\n";
    out += html_heading("machine", "Machine and build");
    out += "<div class=\"facts\">\n" + grid_html(facts_grid(data)) + "</div>\n<h3>Scenes</h3>\n";
    return out + grid_html(scenes_grid(data));
}

std::string charts_html(const std::vector<Chart>& charts, const StaticPictures& pictures, bool alive) {
    std::string out = html_heading("charts", "Charts");
    if (!alive) out += html_paragraph(prose("no_bundles.md"), "verdict part");
    if (!pictures.note.empty()) out += html_paragraph(pictures.note, "note");
    for (const Chart& chart : charts)
        if (chart.section.empty()) out += html_chart(chart, pictures, alive, "h3");
    return out;
}

std::string chapter_html(const Chapter& chapter) {
    std::string out = html_heading(chapter.id, chapter.title);
    if (!chapter.paragraph.empty()) out += html_paragraph(chapter.paragraph);
    for (const ChapterBlock& block : chapter.blocks) {
        std::string inside = block.opening;
        for (const TextGrid& grid : block.grids) inside += grid_html(grid);
        out += block.fold.empty() ? inside : html_folded(block.fold, inside);
    }
    return out;
}

}  // namespace

std::string page_html(const ReportData& data, const std::vector<Chart>& charts,
                      const StaticPictures& pictures, const std::string& scripts) {
    const bool alive = !scripts.empty();
    const std::vector<Chapter> chapters = report_chapters(data);
    std::string out = head_html() + opening_html(data, chapters) + charts_html(charts, pictures, alive);
    out += paper_chapter_html(data, charts, pictures, alive);
    for (const Chapter& chapter : chapters) out += chapter_html(chapter);
    out += "</main>\n";
    if (alive) out += scripts + "<script>" + page_script + "</script>\n";
    return out + "</body>\n</html>\n";
}

}  // namespace edgewise::reports
