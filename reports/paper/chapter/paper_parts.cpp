// SPDX-License-Identifier: MIT
//
// What the chapter on the paper's figures consists of; see paper_chapter.hpp. One function a part.
#include <algorithm>

#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/paper/chapter/paper_tables.hpp"
#include "edgewise/reports/paper/chapter/paper_thrash.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/paper/claims/claims.hpp"

namespace edgewise::reports {

namespace {

ChapterPart static_part(const ReportData& data) {
    return {"Performance, static",
            "Pairs placed at random, no coherence from one to the next: every query starts anew. The paper "
            "reports 3.98e-5 s for V-Clip and 3.43e-5 s for Enhanced GJK, a ratio of 0.86, averaged over all "
            "detections. The ratio is taken of times in the same rounds; preprocessing is not in the times.",
            "",
            {static_grid(data)},
            {}};
}

ChapterPart dynamic_part(const ReportData& data) {
    ChapterPart part{
        "Performance, dynamic",
        "Coherent queries, each started at the end of the last: time against linear and against "
        "angular speed, and bodies kept in close proximity. The paper finds V-Clip slightly faster "
        "throughout.",
        dynamic_section,
        {file_scene_grid(scene_file(data, "paper_proximity"))},
        {}};
    for (const char* name : {"paper_linear_8", "paper_angular_8"})
        part.long_grids.push_back(file_scene_grid(scene_file(data, name)));
    return part;
}

ChapterPart scalability_part(const ReportData& data) {
    ChapterPart part{"Scalability",
                     "In the number of bodies: the paper's broad phase leaves a number of tests that grows "
                     "linearly. In complexity: figures 7 and 8 are figure 6 with 38 and 386 vertices.",
                     scalability_section,
                     {},
                     {}};
    for (const char* name : {"paper_angular_38", "paper_angular_386", "paper_bodies",
                             "paper_bodies_shrinking", "paper_complexity", "paper_cold"})
        part.long_grids.push_back(file_scene_grid(scene_file(data, name)));
    return part;
}

ChapterPart robustness_part(const ReportData& data) {
    return {
        "Robustness",
        "The paper's metric is the percentage of verdicts on which an algorithm disagrees with a control, "
        "Moore and Wilhelms; it found none. Here exact arithmetic is a second control. Inside the band "
        "rounding decides and either verdict is right: a disagreement outside it is a defect, of the "
        "algorithm where the exact verdict says so, else of the control.",
        "",
        {robustness_grid(data)},
        {}};
}

ChapterPart ease_part(const ReportData& data) {
    return {
        "Ease of implementation",
        "The paper's softer metric: how much there is to write, which tolerances there are to set, what has "
        "to be built beforehand. V-Clip's lines are without those of GJK, which it falls back to; every "
        "tolerance is a multiple of the rounding step, none is to be tuned by hand.",
        "",
        {source_grid(), build_grid(data)},
        {}};
}

ChapterPart cost_part(const ReportData& data) {
    return {
        "Cost functions",
        "Equation 1 is N_v C_v + N_p C_p, equation 2 adds N_u C_u: box tests, tests of pairs and updates of "
        "boxes in a step, each with its cost as measured alone. A ratio below 1 says what the cost "
        "function leaves out.",
        "",
        {cost_grid(data, true)},
        {cost_grid(data, false)}};
}

ChapterPart needs_part(const ReportData& data) {
    return {
        "Needs",
        "What a caller asks for decides what a query costs: a verdict alone, the distance, the features or "
        "the closest points, depth and normal of a contact, a proven interval.",
        "",
        {needs_grid(data)},
        {}};
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
