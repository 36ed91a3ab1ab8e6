// SPDX-License-Identifier: MIT
//
// One function a chapter; what is long is folded.
#include "edgewise/reports/page/chapters.hpp"

#include <fmt/core.h>

#include <optional>
#include <utility>

#include "edgewise/reports/additions.hpp"
#include "edgewise/reports/page/fields_chapter.hpp"
#include "edgewise/reports/tables/cache_tables.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/scale_tables.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

/// The first reason for a count that is missing.
std::string why_not_counted(const ReportData& data) {
    for (const ReportCell& cell : data.cells) {
        const measure::Figure figure = cell.figure("counters.instructions");
        if (cell.verified() && !figure.value) return " Not counted here: " + figure.reason + ".";
    }
    return {};
}

Chapter bytes_chapter(const ReportData& data) {
    const std::string shape = reference_shape(data);
    return {"bytes",
            "Bytes per edge",
            prose("bytes.md"),
            {{.title = shape, .grids = {bytes_grid(data, shape)}, .page_only = true},
             {.grids = {bytes_grid(data, "")}, .fold = "All shapes"}}};
}

Chapter layouts_chapter(const ReportData& data) {
    std::string pictures;
    for (const Drawing& drawing : drawings(data))
        pictures += "<div class=\"chart\">" + drawing.svg + "</div>\n";
    std::vector<TextGrid> grids{layout_cost_grid(data)};
    if (TextGrid memory = scene_memory_grid(data); !memory.rows.empty()) grids.push_back(std::move(memory));
    Chapter chapter{"layouts", "What layouts cost", prose("layouts.md"), {{.grids = grids}}, "Layouts"};
    ChapterBlock claim{.title = "A line per vertex",
                       .paragraph = prose("support.md") + support_verdict(data)};
    if (TextGrid supports = support_grid(data); !supports.rows.empty()) claim.grids = {std::move(supports)};
    chapter.blocks.push_back(std::move(claim));
    if (TextGrid scales = scale_grid(data); !scales.rows.empty())
        chapter.blocks.push_back({.title = "One table, many scales", .grids = {std::move(scales)}});
    if (!pictures.empty())
        chapter.blocks.push_back({.elements = pictures,
                                  .fold = "The layouts draw themselves: the table of a cube",
                                  .page_only = true});
    return chapter;
}

Chapter caches_chapter(const ReportData& data) {
    const bool modelled = !modelled_cells(data).empty();
    Chapter chapter{"caches", "Caches", prose(modelled ? "caches.md" : "no_caches.md"), {}};
    if (!modelled) return chapter;
    chapter.blocks = {{.grids = {misses_grid(data), working_sets_grid(data), policy_grid(data)}}};
    for (const std::string& machine : modelled_machines(data)) {
        ChapterBlock block{.grids = {causes_grid(data, machine)}, .fold = machine + ": why, what and where"};
        for (const std::string& level : broken_down_levels(data, machine))
            for (const store::FigureName& by : {misses_by_field, misses_by_step})
                block.grids.push_back(breakdown_grid(data, machine, level, by));
        chapter.blocks.push_back(std::move(block));
    }
    return chapter;
}

Chapter counters_chapter(const ReportData& data) {
    return {"counters",
            "Counters and heap",
            prose("counters.md") + why_not_counted(data),
            {{.grids = {counters_grid(data)}}},
            "Counters"};
}

/// The reference shape in full view, all shapes folded.
Chapter times_chapter(const ReportData& data) {
    Chapter chapter{"times", "Times", prose("times.md"), {}};
    for (const std::string& scene : scene_labels(data)) {
        ChapterBlock shown{.title = scene, .page_only = true};
        std::vector<ChapterBlock> all;
        for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping}) {
            const TextGrid grid = time_grid(data, scene, kind, "");
            if (grid.rows.empty()) continue;
            if (TextGrid reference = time_grid(data, scene, kind, reference_shape(data));
                !reference.rows.empty())
                shown.grids.push_back(std::move(reference));
            all.push_back({.grids = {grid},
                           .fold = fmt::format("{}, {} pairs, all shapes ({})", scene, pair_name(kind),
                                               plural(grid.rows.size(), "cell"))});
        }
        chapter.blocks.push_back(std::move(shown));
        chapter.blocks.insert(chapter.blocks.end(), all.begin(), all.end());
    }
    return chapter;
}

/// Where other libraries were measured.
std::optional<Chapter> peers_chapter(const ReportData& data) {
    if (!has_peers(data) && data.effort.empty()) return std::nullopt;
    Chapter chapter{
        "peers", "Beside other libraries", prose("peers.md"), {{.grids = {peers_grid(data)}}}, "Peers"};
    for (const std::string& scene : scene_labels(data)) {
        TextGrid grid = peer_grid(data, scene);
        if (!grid.rows.empty()) chapter.blocks.push_back({.title = scene, .grids = {std::move(grid)}});
    }
    if (!data.effort.empty())
        chapter.blocks.push_back({.title = "What a query takes",
                                  .paragraph = prose("effort.md"),
                                  .grids = {effort_grid(data), effort_floor_grid(data)}});
    return chapter;
}

/// The reference shape in full view, all shapes folded.
Chapter fronts_chapter(const ReportData& data) {
    const std::string shape = reference_shape(data);
    Chapter chapter{"fronts",
                    "Speed against error",
                    prose("fronts.md"),
                    {{.title = shape, .grids = {front_grid(data, shape)}, .page_only = true}},
                    "Fronts"};
    TextGrid all = front_grid(data, "");
    std::string fold = fmt::format("All scenes and shapes ({})", plural(all.rows.size(), "row"));
    chapter.blocks.push_back({.grids = {std::move(all)}, .fold = std::move(fold)});
    if (TextGrid left_out = left_out_grid(data); !left_out.rows.empty())
        chapter.blocks.push_back({.grids = {std::move(left_out)}});
    return chapter;
}

Chapter errors_chapter(const ReportData& data) {
    return {"errors",
            "Errors",
            prose("errors.md"),
            {{.grids = {error_summary_grid(data)}},
             {.grids = {error_grid(data)}, .fold = fmt::format("Every cell ({})", data.cells.size())}}};
}

Chapter stability_chapter(const ReportData& data) {
    if (data.stability.empty()) return {"stability", "Stability", prose("no_stability.md"), {}};
    Chapter chapter{"stability", "Stability", prose("stability.md"), {}};
    chapter.blocks = {{.grids = {stability_summary_grid(data)}},
                      {.grids = {stability_grid(data)},
                       .fold = fmt::format("Every family ({})", plural(data.stability.size(), "row"))}};
    return chapter;
}

Chapter cells_chapter(const ReportData& data) {
    return {
        "cells",
        "All cells",
        {},
        {{.paragraph = prose("cells.md"), .page_only = true},
         {.grids = {cells_grid(data)}, .fold = fmt::format("All {}", plural(data.cells.size(), "cell"))}}};
}

}  // namespace

std::vector<Chapter> report_chapters(const ReportData& data, const std::vector<Chart>& charts) {
    std::vector<Chapter> chapters;
    for (const Addition& addition : additions())
        if (auto chapter = addition.chapter(data, charts)) chapters.push_back(std::move(*chapter));
    if (auto chapter = peers_chapter(data)) chapters.push_back(std::move(*chapter));
    for (const auto chapter :
         {bytes_chapter, layouts_chapter, caches_chapter, counters_chapter, times_chapter, fronts_chapter,
          errors_chapter, stability_chapter, cells_chapter})
        chapters.push_back(chapter(data));
    if (auto chapter = fields_chapter(data)) chapters.push_back(std::move(*chapter));
    return chapters;
}

}  // namespace edgewise::reports
