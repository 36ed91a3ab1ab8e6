// SPDX-License-Identifier: MIT
//
// See markdown.hpp. Pictures are linked, where there are any.
#include "edgewise/reports/page/markdown.hpp"

#include <fmt/core.h>

#include "edgewise/reports/page/chapters.hpp"
#include "edgewise/reports/page/page.hpp"
#include "edgewise/reports/page/page_parts.hpp"
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

std::string section(const std::string& title, const std::string& paragraph = {}) {
    return fmt::format("## {}\n\n{}", title, paragraph.empty() ? "" : paragraph + "\n\n");
}

std::string charts_markdown(const std::vector<Chart>& charts, const StaticPictures& pictures) {
    std::string out = section("Charts");
    if (!pictures.note.empty()) out += pictures.note + "\n\n";
    for (const Chart& chart : charts)
        if (chart.section.empty()) out += markdown_chart(chart, pictures, "###");
    return out;
}

std::string chapter_markdown(const Chapter& chapter) {
    std::string out = section(chapter.title, chapter.paragraph);
    for (const ChapterBlock& block : chapter.blocks)
        if (!block.page_only)
            for (const TextGrid& grid : block.grids) out += grid_markdown(grid);
    return out;
}

}  // namespace

std::string report_markdown(const ReportData& data, const std::vector<Chart>& charts,
                            const StaticPictures& pictures) {
    std::string out =
        fmt::format("# Edgewise report\n\n{}\n\n**{}**\n\n", prose("purpose.md"), verdict_line(data));
    const TextGrid problems = problems_grid(data);
    if (!problems.rows.empty()) out += section("Failed and unavailable cells") + grid_markdown(problems);
    out += section("Machine and build") + grid_markdown(facts_grid(data)) + grid_markdown(scenes_grid(data));
    out += charts_markdown(charts, pictures) + paper_chapter_markdown(data, charts, pictures);
    for (const Chapter& chapter : report_chapters(data)) out += chapter_markdown(chapter);
    return out;
}

}  // namespace edgewise::reports
