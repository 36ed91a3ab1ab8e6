// SPDX-License-Identifier: MIT
//
// What the chapter on the paper's figures consists of; see paper_chapter.hpp. One function per part.
#include <algorithm>

#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/paper/chapter/paper_tables.hpp"
#include "edgewise/reports/paper/chapter/paper_thrash.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/paper/claims/claims.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

ChapterPart static_part(const ReportData& data) {
    return {"Performance, static", prose("part_static.md"), "", {static_grid(data)}, {}};
}

ChapterPart dynamic_part(const ReportData& data) {
    ChapterPart part{"Performance, dynamic",
                     prose("part_dynamic.md"),
                     dynamic_section,
                     {file_scene_grid(scene_file(data, "paper_proximity"))},
                     {}};
    for (const char* name : {"paper_linear_8", "paper_angular_8"})
        part.long_grids.push_back(file_scene_grid(scene_file(data, name)));
    return part;
}

ChapterPart scalability_part(const ReportData& data) {
    ChapterPart part{"Scalability", prose("part_scalability.md"), scalability_section, {}, {}};
    for (const char* name : {"paper_angular_38", "paper_angular_386", "paper_bodies",
                             "paper_bodies_shrinking", "paper_complexity", "paper_cold"})
        part.long_grids.push_back(file_scene_grid(scene_file(data, name)));
    return part;
}

ChapterPart robustness_part(const ReportData& data) {
    return {"Robustness", prose("part_robustness.md"), "", {robustness_grid(data)}, {}};
}

ChapterPart ease_part(const ReportData& data) {
    return {"Ease of implementation", prose("part_ease.md"), "", {source_grid(), build_grid(data)}, {}};
}

ChapterPart cost_part(const ReportData& data) {
    return {"Cost functions", prose("part_cost.md"), "", {cost_grid(data, true)}, {cost_grid(data, false)}};
}

ChapterPart needs_part(const ReportData& data) {
    return {"Needs", prose("part_needs.md"), "", {needs_grid(data)}, {}};
}

ChapterPart thrash_part(const ReportData& data) {
    return {"The thrash at 386 vertices",
            thrash_paragraph(data),
            thrash_section,
            {thrash_grid(data), paging_grid(data)},
            {file_scene_grid(scene_file(data, "paper_caches_here"))}};
}

ChapterPart own_part(const ReportData& data) {
    ChapterPart part{"Your own scenes", "Scenes from files that are not the paper's.", own_section, {}, {}};
    for (const StoredScene& scene : scene_files(data))
        if (!is_of_paper(scene.name)) part.long_grids.push_back(file_scene_grid(scene));
    return part;
}

bool has_paper_scene(const ReportData& data) {
    return std::any_of(data.scene_files.begin(), data.scene_files.end(),
                       [](const auto& file) { return is_of_paper(file.first); });
}

}  // namespace

bool has_paper_chapter(const ReportData& data) { return !data.scene_files.empty(); }

std::string paper_chapter_title(const ReportData& data) {
    return has_paper_scene(data) ? "The paper's figures" : "Scenes from files";
}

std::vector<TextGrid> opening_grids(const ReportData& data) { return {claims_grid(data)}; }

std::vector<ChapterPart> chapter_parts(const ReportData& data) {
    std::vector<ChapterPart> parts;
    if (has_paper_scene(data))
        parts = {static_part(data), dynamic_part(data), scalability_part(data), robustness_part(data),
                 ease_part(data),   cost_part(data),    needs_part(data),       thrash_part(data)};
    parts.push_back(own_part(data));
    return parts;
}

}  // namespace edgewise::reports
