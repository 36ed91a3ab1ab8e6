// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/chapter/thrash_study.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/paper/claims/assumptions.hpp"
#include "edgewise/reports/paper/claims/claims.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

constexpr const char* paper_title = "What did the paper find, and do we?";

/// A paragraph, then its charts, then its grids; left out without charts and rows.
struct ChapterPart {
    std::string title, paragraph;
    std::string section;                      ///< of its charts (paper_charts.hpp); empty: it has none
    std::vector<TextGrid> grids, long_grids;  ///< in full view; folded
};

std::vector<TextGrid> scene_grids(const ReportData& data, const std::vector<std::string>& names) {
    std::vector<TextGrid> grids;
    for (const std::string& name : names) grids.push_back(file_scene_grid(scene_file(data, name)));
    return grids;
}

std::vector<ChapterPart> paper_parts(const ReportData& data) {
    return {
        {"Performance, static", prose("part_static.md"), "", {static_grid(data), static_gap_grid(data)}, {}},
        {"Performance, dynamic", prose("part_dynamic.md"), dynamic_section,
         [&] {
             std::vector<TextGrid> grids = scene_grids(data, {"paper_proximity"});
             grids.push_back(margin_grid(data));
             grids.push_back(tolerance_grid(data));
             return grids;
         }(),
         scene_grids(data, {"paper_linear_8", "paper_angular_8"})},
        {"Scalability",
         prose("part_scalability.md"),
         scalability_section,
         {},
         scene_grids(data, {"paper_angular_38", "paper_angular_386", "paper_bodies", "paper_bodies_shrinking",
                            "paper_complexity", "paper_cold"})},
        {"Robustness", prose("part_robustness.md"), "", {robustness_grid(data), raw_vclip_grid(data)}, {}},
        {"Ease of implementation", prose("part_ease.md"), "", {build_grid(data)}, {}},
        {"Cost functions", prose("part_cost.md"), "", {cost_grid(data, true)}, {cost_grid(data, false)}},
        {"Needs", prose("part_needs.md"), "", {all_needs_grid(data), needs_grid(data)}, {}},
        {"The thrash at 386 vertices",
         thrash_paragraph(data),
         thrash_section,
         {realised_grid(data), paging_grid(data)},
         [&] {
             std::vector<TextGrid> grids = {mechanism_grid(data), thrash_grid(data)};
             for (TextGrid& grid : scene_grids(data, {"paper_caches_here"})) grids.push_back(std::move(grid));
             return grids;
         }()}};
}

ChapterPart own_part(const ReportData& data) {
    ChapterPart part{"", "Scenes from files that are not the paper's.", own_section, {}, {}};
    for (const StoredScene& scene : scene_files(data))
        if (!is_of_paper(scene.name)) part.long_grids.push_back(file_scene_grid(scene));
    return part;
}

bool has_paper_scene(const ReportData& data) {
    return std::ranges::any_of(data.scene_files, [](const auto& file) { return is_of_paper(file.first); });
}

void add_part(ChapterPart part, const std::vector<Chart>& charts, std::vector<ChapterBlock>& blocks) {
    const auto without_rows = [](const TextGrid& grid) { return grid.rows.empty(); };
    std::erase_if(part.grids, without_rows);
    std::erase_if(part.long_grids, without_rows);
    const bool drawn = !part.section.empty() && std::ranges::any_of(charts, [&](const Chart& chart) {
        return chart.section == part.section;
    });
    if (!drawn && part.grids.empty() && part.long_grids.empty()) return;
    blocks.push_back({.title = part.title,
                      .paragraph = part.paragraph,
                      .section = part.section,
                      .grids = std::move(part.grids)});
    for (TextGrid& grid : part.long_grids) {
        const std::string fold = fmt::format("{} ({})", grid.caption, plural(grid.rows.size(), "row"));
        blocks.push_back({.grids = {std::move(grid)}, .fold = fold});
    }
}

Chapter paper_chapter(const ReportData& data, const std::vector<Chart>& charts) {
    Chapter chapter{"paper", paper_title, {}, {}, "The paper"};
    if (TextGrid assumed = assumptions_grid(data); !assumed.rows.empty())
        chapter.blocks.push_back({.title = "What we had to assume",
                                  .paragraph = assumptions_paragraph(data),
                                  .grids = {std::move(assumed)}});
    chapter.blocks.push_back({.grids = {claims_grid(data)}});
    for (ChapterPart& part : paper_parts(data)) add_part(std::move(part), charts, chapter.blocks);
    return chapter;
}

}  // namespace

std::vector<Chapter> paper_chapters(const ReportData& data, const std::vector<Chart>& charts) {
    std::vector<Chapter> chapters;
    Chapter own{"own", "Your own scenes", {}, {}, "Your scenes"};
    add_part(own_part(data), charts, own.blocks);
    if (!own.blocks.empty()) chapters.push_back(std::move(own));
    chapters.push_back(has_paper_scene(data)
                           ? paper_chapter(data, charts)
                           : Chapter{"paper", paper_title, prose("no_paper.md"), {}, "The paper"});
    return chapters;
}

}  // namespace edgewise::reports
