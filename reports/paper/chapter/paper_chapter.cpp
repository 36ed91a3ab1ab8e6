// SPDX-License-Identifier: MIT
//
// The chapter on the paper's figures as HTML and as Markdown; what is in it: paper_parts.cpp.
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "edgewise/reports/page/page_parts.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

std::vector<const Chart*> charts_of(const ChapterPart& part, const std::vector<Chart>& charts) {
    std::vector<const Chart*> own;
    for (const Chart& chart : charts)
        if (!part.section.empty() && chart.section == part.section) own.push_back(&chart);
    return own;
}

bool is_empty(const ChapterPart& part, const std::vector<Chart>& charts) {
    const auto has_rows = [](const TextGrid& grid) { return !grid.rows.empty(); };
    return charts_of(part, charts).empty() && std::none_of(part.grids.begin(), part.grids.end(), has_rows) &&
           std::none_of(part.long_grids.begin(), part.long_grids.end(), has_rows);
}

std::string part_html(const ChapterPart& part, const std::vector<Chart>& charts,
                      const StaticPictures& pictures, bool alive) {
    std::string out = fmt::format("<h3>{}</h3>\n", html_text(part.title)) + html_paragraph(part.paragraph);
    for (const Chart* chart : charts_of(part, charts)) out += html_chart(*chart, pictures, alive, "h4");
    for (const TextGrid& grid : part.grids)
        if (!grid.rows.empty()) out += grid_html(grid);
    for (const TextGrid& grid : part.long_grids)
        if (!grid.rows.empty())
            out += html_folded(fmt::format("{} ({})", grid.caption, plural(grid.rows.size(), "row")),
                               grid_html(grid));
    return out;
}

std::string part_markdown(const ChapterPart& part, const std::vector<Chart>& charts,
                          const StaticPictures& pictures) {
    std::string out = fmt::format("### {}\n\n{}\n\n", part.title, part.paragraph);
    for (const Chart* chart : charts_of(part, charts)) out += markdown_chart(*chart, pictures, "####");
    for (const auto* grids : {&part.grids, &part.long_grids})
        for (const TextGrid& grid : *grids)
            if (!grid.rows.empty()) out += grid_markdown(grid);
    return out;
}

}  // namespace

std::string paper_chapter_html(const ReportData& data, const std::vector<Chart>& charts,
                               const StaticPictures& pictures, bool alive) {
    if (!has_paper_chapter(data)) return {};
    std::string out = html_heading("paper", paper_chapter_title(data));
    for (const TextGrid& grid : opening_grids(data)) out += grid_html(grid);
    for (const ChapterPart& part : chapter_parts(data))
        if (!is_empty(part, charts)) out += part_html(part, charts, pictures, alive);
    return out;
}

std::string paper_chapter_markdown(const ReportData& data, const std::vector<Chart>& charts,
                                   const StaticPictures& pictures) {
    if (!has_paper_chapter(data)) return {};
    std::string out = fmt::format("## {}\n\n", paper_chapter_title(data));
    for (const TextGrid& grid : opening_grids(data)) out += grid_markdown(grid);
    for (const ChapterPart& part : chapter_parts(data))
        if (!is_empty(part, charts)) out += part_markdown(part, charts, pictures);
    return out;
}

}  // namespace edgewise::reports
