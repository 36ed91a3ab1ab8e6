// SPDX-License-Identifier: MIT
//
// The report as Markdown. Pictures are linked, where there are any.
#include <fmt/core.h>

#include "edgewise/reports/page/chapters.hpp"
#include "edgewise/reports/page/page.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

/// `level`: of the heading, such as "###"; nothing for an empty title or paragraph.
std::string headed(const std::string& level, const std::string& title, const std::string& paragraph = {}) {
    return (title.empty() ? "" : level + " " + title + "\n\n") +
           (paragraph.empty() ? "" : paragraph + "\n\n");
}

std::string charts_markdown(const std::vector<Chart>& charts, const StaticPictures& pictures,
                            const std::string& section, const std::string& level) {
    std::string out;
    for (const Chart& chart : charts) {
        if (chart.section != section) continue;
        out += headed(level, chart.title, chart.how_to_read);
        if (pictures.svg.contains(chart.name))
            out += fmt::format("![{}](figures/{}.svg)\n\n", chart.title, chart.name);
        for (const std::string& note : chart.notes) out += "- " + markdown_text(note) + "\n";
        if (!chart.notes.empty()) out += "\n";
    }
    return out;
}

std::string block_markdown(const ChapterBlock& block, const std::vector<Chart>& charts,
                           const StaticPictures& pictures) {
    if (block.page_only) return {};
    std::string out = headed("###", block.title, block.paragraph);
    if (!block.section.empty()) out += charts_markdown(charts, pictures, block.section, "####");
    for (const TextGrid& grid : block.grids) out += grid_markdown(grid);
    return out;
}

}  // namespace

std::string report_markdown(const ReportData& data, const std::vector<Chart>& charts,
                            const StaticPictures& pictures) {
    std::string out =
        fmt::format("# Edgewise report\n\n{}\n\n**{}**\n\n", prose("purpose.md"), verdict_line(data));
    const TextGrid problems = problems_grid(data);
    if (!problems.rows.empty()) out += headed("##", "Failed and unavailable cells") + grid_markdown(problems);
    out += headed("##", "Machine and build") + grid_markdown(facts_grid(data)) +
           grid_markdown(scenes_grid(data));
    out += headed("##", "Charts", pictures.note) + charts_markdown(charts, pictures, "", "###");
    for (const Chapter& chapter : report_chapters(data, charts)) {
        out += headed("##", chapter.title, chapter.paragraph);
        for (const ChapterBlock& block : chapter.blocks) out += block_markdown(block, charts, pictures);
    }
    return out;
}

}  // namespace edgewise::reports
