// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/paper/claims/claim_cells.hpp"
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
        {"Performance, dynamic",
         prose("part_dynamic.md"),
         dynamic_section,
         {file_scene_grid(scene_file(data, "paper_proximity")), margin_grid(data), tolerance_grid(data)},
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
         {mechanism_grid(data), thrash_grid(data), file_scene_grid(scene_file(data, "paper_caches_here"))}}};
}

ChapterPart own_part(const ReportData& data) {
    ChapterPart part{"", "Scenes from files that are not the paper's.", own_section, {}, {}};
    for (const StoredScene& scene : scene_files(data))
        if (!is_of_paper(scene.name)) part.long_grids.push_back(file_scene_grid(scene));
    return part;
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
    for (const TextGrid& grid : part.long_grids) blocks.push_back(folded(grid, grid.caption));
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
    const bool has_scenes =
        std::ranges::any_of(data.scene_files, [](const auto& file) { return is_of_paper(file.first); });
    chapters.push_back(has_scenes ? paper_chapter(data, charts)
                                  : Chapter{"paper", paper_title, prose("no_paper.md"), {}, "The paper"});
    return chapters;
}

namespace {

/// The scene and the place on its axis of the cells of one value.
struct ValuePlace {
    const char* assumption;
    std::string value;
    bool ours;
    const char *scene, *parameter;
    double x;
    std::string axes = {};  ///< of its cells; empty: plain
};

constexpr double middle_speed = 4, slowest_speed = 1;  // rad/s
constexpr double our_step = 1.0 / 60;

std::vector<ValuePlace> places() {
    std::vector<ValuePlace> all;
    for (const int parts : {120, 60, 30, 2})
        all.push_back({"time step", fmt::format("1/{} s", parts), parts == 60, "paper_time_step",
                       "rotation_step", middle_speed / parts});
    for (const double margin : {0.0, 0.05, 0.1, 0.2})
        all.push_back(
            {"margin", fmt::format("{} diagonals", margin), margin == 0, "paper_margin", "margin", margin});
    for (const int bodies : {50, 100, 400, 600})
        all.push_back({"bodies", std::to_string(bodies), false, "paper_body_count", "bodies", 1.0 * bodies});
    for (const int number : {0, 1, 2, 3, 4})
        all.push_back({"population", std::to_string(number + 1), number == 0, "paper_seeds", "population",
                       1.0 * number});
    all.push_back({"tables", "shared by all bodies", false, "paper_time_step", "rotation_step",
                   middle_speed * our_step, "sharing=shared"});
    all.push_back({"asked for", "the verdict alone", false, "paper_time_step", "rotation_step",
                   middle_speed * our_step, "needs=verdict"});
    for (const bool named : {false, true})
        all.push_back({"tolerance at 1 rad/s", named ? "1e-5" : "0", !named, "paper_tolerance",
                       "rotation_step", slowest_speed * our_step, named ? "contact_tolerance=1e-05" : ""});
    return all;
}

const ReportCell* cell_at(const ReportData& data, const ValuePlace& place, int vertices,
                          const std::string& algorithm) {
    const CellKey key{place.scene, paper_shape(vertices), algorithm,
                      place.axes.empty() ? "aos_f64" : "aos_f64 " + place.axes};
    const auto found = in_range(cells_along(data, key, place.parameter), {place.x, place.x});
    return found.empty() ? nullptr : found.front().cell;
}

Evidence not_stored(const ValuePlace& place) {
    return no_evidence(fmt::format("no cells of scene {} at {} {}{} are stored", place.scene, place.parameter,
                                   number_text(place.x), place.axes.empty() ? "" : ", " + place.axes));
}

/// Both were timed in the same rounds as the scene's plain V-Clip, which is `vclip` itself if no axis is
/// varied.
Evidence vclip_over_gjk(const ReportData& data, const ValuePlace& place, int vertices) {
    const ReportCell *vclip = cell_at(data, place, vertices, "vclip"),
                     *gjk = cell_at(data, place, vertices, "gjk");
    if (!vclip || !gjk) return not_stored(place);
    if (place.axes.empty()) return quotient(exact_evidence(1), time_ratio(*gjk, *vclip));
    return quotient(time_of(*vclip), time_of(*gjk));
}

Evidence growth(const ReportData& data, const ValuePlace& place, const std::string& algorithm) {
    const ReportCell *large = cell_at(data, place, 386, algorithm),
                     *small = cell_at(data, place, 38, algorithm);
    return large && small ? quotient(time_of(*large), time_of(*small)) : not_stored(place);
}

/// What V-Clip is.
std::string judged(const Evidence& over_gjk) {
    if (!over_gjk.value) return "not measured";
    if (over_gjk.high < 1) return "faster";
    return over_gjk.low > 1 ? "slower" : "undecided";
}

GridCell evidence_cell(const Evidence& evidence) {
    return evidence.value ? GridCell{evidence_text(evidence, "1")} : missing_cell(evidence.missing);
}

/// "V-Clip is faster at 386 vertices under every value", or under which not.
std::string sentence_of(const std::vector<AssumedValue>& values, std::size_t size) {
    std::map<std::string, std::string> under;  // the values by verdict
    for (const AssumedValue& one : values)
        append(under[judged(one.vclip_over_gjk[size])], one.assumption + " " + one.value);
    const bool always = under.size() - under.count("not measured") == 1;
    std::string out;
    for (const char* verdict : {"faster", "slower", "undecided"})
        if (const auto found = under.find(verdict); found != under.end())
            append(out,
                   fmt::format("{} {}", verdict,
                               always ? "under every value measured" : "(" + found->second + ")"),
                   "; ");
    return out.empty() ? out : fmt::format("At {} vertices V-Clip is {}. ", angular_sizes[size], out);
}

}  // namespace

std::vector<AssumedValue> assumed_values(const ReportData& data) {
    std::vector<AssumedValue> values;
    for (const ValuePlace& place : places()) {
        AssumedValue one{place.assumption, place.value, place.ours, {}, {}, {}};
        for (std::size_t size = 0; size < std::size(angular_sizes); ++size)
            one.vclip_over_gjk[size] = vclip_over_gjk(data, place, angular_sizes[size]);
        one.vclip_growth = growth(data, place, "vclip");
        one.gjk_growth = growth(data, place, "gjk");
        values.push_back(std::move(one));
    }
    return values;
}

TextGrid assumptions_grid(const ReportData& data) {
    TextGrid grid{
        "What we had to assume, each varied alone (aos_f64, 4 rad/s except for the tolerance, queries that "
        "start warm; ratios of times with 95 % intervals of this run's rounds)",
        columns_of("assumption|value|ours|#V-Clip / GJK, 8 vertices|#38|#386|V-Clip at 8, 38, 386 is|"
                   "#386 / 38, V-Clip|#386 / 38, GJK")};
    for (const AssumedValue& one : assumed_values(data)) {
        std::string verdicts;
        bool any = false;
        for (const Evidence& ratio : one.vclip_over_gjk) {
            append(verdicts, judged(ratio));
            any = any || ratio.value;
        }
        if (!any) continue;
        const auto& ratios = one.vclip_over_gjk;
        grid.add(one.assumption, one.value, one.ours ? "yes" : "", evidence_cell(ratios[0]),
                 evidence_cell(ratios[1]), evidence_cell(ratios[2]), verdicts,
                 evidence_cell(one.vclip_growth), evidence_cell(one.gjk_growth));
    }
    return grid;
}

std::string assumptions_paragraph(const ReportData& data) {
    const std::vector<AssumedValue> values = assumed_values(data);
    std::string out;
    for (std::size_t size = 0; size < std::size(angular_sizes); ++size) out += sentence_of(values, size);
    return out;
}

}  // namespace edgewise::reports
