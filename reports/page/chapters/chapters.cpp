// SPDX-License-Identifier: MIT
//
// One function a chapter; what is long is made when it is opened.
#include "edgewise/reports/page/chapters/chapters.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/additions.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

/// The last step of the first walk, with its first and its last table; a script shows the others.
ChapterBlock walk_block(const BodyWalk& walk) {
    std::string figures;
    for (const WalkDrawing& body : walk.bodies) figures += walk_figure(body, "trail");
    figures += walk_figure(walk.tables.front(), "lines") + walk_figure(walk.tables.back(), "lines");
    return {.title = "One query, step by step",
            .elements = fmt::format(
                fmt::runtime(report_text("page.walk.html")), fmt::arg("title", html_text(walk.title)),
                fmt::arg("said", html_text(walk.said.back())), fmt::arg("figures", figures))};
}

Chapter body_chapter(const Answer&, const ReportData& data) {
    Chapter chapter{.id = "body", .title = "Where on the body is the work?", .link = "The body"};
    const HeatOnBodies found = heat_on_bodies(data);
    if (found.heats.empty()) {
        chapter.paragraph = prose("no_body.md");
        return chapter;
    }
    const BodyHeat& first = found.heats.front();
    std::string options;
    for (std::size_t i = 0; i < found.heats.size(); ++i)
        options += html_option(std::to_string(i), found.heats[i].title(), i == 0);
    chapter.paragraph = prose("body.md");
    chapter.blocks = {
        {.elements = fmt::format(fmt::runtime(report_text("page.body.html")),
                                 fmt::arg("choice", html_select("body-cell", "reads of", options)),
                                 fmt::arg("title", html_text(first.title())),
                                 fmt::arg("svg", body_svg(found.bodies.at(first.cell->shape), first)),
                                 fmt::arg("said", html_text(first.sentence())))}};
    if (!found.walks.empty()) chapter.blocks.push_back(walk_block(found.walks.front()));
    return chapter;
}

}  // namespace

ChapterBlock folded(TextGrid grid, const std::string& what) {
    std::string line = fmt::format("{} ({})", what, plural(grid.rows.size(), "row"));
    return {.grids = {std::move(grid)}, .fold = std::move(line)};
}

namespace {

Chapter bytes_chapter(const Answer&, const ReportData& data) {
    return {.id = "bytes",
            .title = "How many bytes, and for what?",
            .paragraph = prose("bytes.md"),
            .blocks = {{.section = "bytes", .grids = {bytes_grid(data, reference_shape(data))}},
                       folded(bytes_grid(data, ""), "All shapes")},
            .link = "Bytes",
            .sentence = bytes_sentence(data)};
}

/// Drawings that hold more than plain shapes are left out, and said to be.
ChapterBlock drawings_block(const ReportData& data) {
    std::string pictures;
    for (const auto& [table, svg] : data.meta_with(store::drawing_key)) {
        const auto safe = safe_svg(svg);
        pictures += safe
                        ? "<div class=\"wide drawing\" tabindex=\"0\" role=\"group\" aria-label=\"table of " +
                              html_text(table) + "\">" + *safe + "</div>\n"
                        : html_paragraph("The stored picture of " + table +
                                         " holds more than shapes and text, and is not shown.");
    }
    if (pictures.empty()) return {};
    return {.elements = pictures, .fold = "The layouts draw themselves: the table of a cube, line by line"};
}

Chapter layouts_chapter(const Answer&, const ReportData& data) {
    Chapter chapter{
        .id = "layouts",
        .title = "What does a layout cost?",
        .paragraph = prose("layouts.md"),
        .blocks = {{.grids = {layout_cost_grid(data)}},
                   {.grids = {scene_memory_grid(data)}},
                   {.title = "A line per vertex", .paragraph = prose("support.md") + support_verdict(data)},
                   {.grids = {support_grid(data)}},
                   {.title = "Where to begin", .paragraph = prose("seeds.md"), .grids = {seeds_grid(data)}},
                   {.section = "seeds"},
                   {.title = "One table, many scales", .grids = {scale_grid(data)}}},
        .link = "Layouts",
        .sentence = layouts_sentence(data)};
    if (ChapterBlock pictures = drawings_block(data); !pictures.fold.empty())
        chapter.blocks.push_back(std::move(pictures));
    return chapter;
}

/// Returns the machine with misses in full view: this machine if it was modelled, else the first.
std::string shown_machine(const std::vector<std::string>& machines) {
    const bool host = std::ranges::find(machines, "host") != machines.end();
    return host ? "host" : machines.front();
}

/// A scene's kind, body and parameters without its number of bodies.
std::string motion_without_bodies(const ReportCell& cell) {
    auto parameters = input::json_or_null(cell.scene_parameters);
    if (parameters.is_object()) parameters.erase("bodies");
    return scene_kind(cell) + cell.shape + parameters.dump();
}

/// From how many bodies with a table each the layout to take is faster than the paper's: a bracket of numbers
/// that were measured in one motion, with the ratios there; empty if none was measured.
std::string many_tables_sentence(const Answer& answer) {
    const std::optional<Recommendation> take = recommendation_of(answer.own);
    if (!take) return {};
    if (answer.baseline.is(take->algorithm, take->table))
        return "With a table each, the paper's layout is the one to take.";
    std::map<std::string, std::map<double, const RankedCell*>> by_motion;
    for (const Recommendation::InScene& one : take->scenes)
        if (const auto bodies = one.cell ? parameter_of(*one.cell->cell, "bodies") : std::nullopt)
            by_motion[motion_without_bodies(*one.cell->cell)][*bodies] = one.cell;
    if (by_motion.empty()) return {};
    const auto numbers = [](const auto& motion) { return motion.second.size(); };
    const auto& by_bodies = std::ranges::max_element(by_motion, {}, numbers)->second;
    std::string slower, faster;  // the most bodies where it is not faster; the fewest from which on it is
    for (const auto& [bodies, cell] : by_bodies) {
        const std::string at = fmt::format("{} of its time with {} bodies", ratio_text(*cell), bodies);
        if (cell->high() >= 1) slower = at, faster.clear();
        if (cell->high() < 1 && faster.empty()) faster = at;
    }
    return fmt::format("With a table each, {} for {} {}: {}{}{}.", take->example().cell->name(),
                       by_bodies.begin()->second->cell->shape,
                       faster.empty() ? "is not faster than the paper's layout"
                       : slower.empty()
                           ? "is faster than the paper's layout from the fewest bodies measured on"
                           : "becomes faster than the paper's layout between numbers measured",
                       slower, slower.empty() || faster.empty() ? "" : ", ", faster);
}

Chapter caches_chapter(const Answer& answer, const ReportData& data) {
    const bool modelled = !modelled_cells(data).empty();
    Chapter chapter{.id = "caches",
                    .title = "What does a miss cost me, and from how many bodies on?",
                    .paragraph = prose(modelled ? "caches.md" : "no_caches.md"),
                    .link = "Misses",
                    .sentence = many_tables_sentence(answer)};
    if (chapter.sentence.empty()) chapter.sentence = misses_sentence(data);
    const std::vector<std::string> machines = modelled_machines(data);
    if (!modelled || machines.empty()) return chapter;
    chapter.blocks = {
        {.paragraph = many_tables_sentence(answer).empty() ? "" : misses_sentence(data)},
        {.section = "misses", .grids = {misses_grid(data, shown_machine(machines))}},
        {.paragraph = policy_sentence(data)},
        folded(working_sets_grid(data), "Working sets, knees, and what was ever touched"),
        folded(policy_grid(data), "Rankings under other replacement policies, and with prefetchers")};
    for (const std::string& machine : machines) {
        ChapterBlock block{.grids = {misses_grid(data, machine), causes_grid(data, machine)},
                           .fold = machine + ": misses, why, what and where"};
        for (const std::string& level : broken_down_levels(data, machine))
            for (const store::FigureName& by : {misses_by_field, misses_by_step})
                block.grids.push_back(breakdown_grid(data, machine, level, by));
        chapter.blocks.push_back(std::move(block));
    }
    return chapter;
}

Chapter counters_chapter(const Answer&, const ReportData& data) {
    return {.id = "counters",
            .title = "What did the processor and the kernel count?",
            .paragraph = prose("counters.md"),
            .blocks = {{.grids = {counters_grid(data)}}},
            .link = "Counters",
            .sentence = counters_sentence(data)};
}

Chapter times_chapter(const Answer& answer, const ReportData& data) {
    Chapter chapter{.id = "times",
                    .title = "How does time grow with the body?",
                    .paragraph = prose("times.md"),
                    .blocks = {{.section = "times"}},
                    .link = "Times",
                    .sentence = times_sentence(answer, data)};
    for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping}) {
        std::vector<TextGrid> scenes;
        std::size_t rows = 0;
        for (const std::string& scene : scene_labels(data)) {
            TextGrid grid = time_grid(data, scene, kind);
            rows += grid.rows.size();
            if (!grid.rows.empty()) scenes.push_back(std::move(grid));
        }
        if (!scenes.empty())
            chapter.blocks.push_back({.grids = std::move(scenes),
                                      .fold = fmt::format("Of {} pairs, scene by scene ({})", pair_name(kind),
                                                          plural(rows, "row"))});
    }
    return chapter;
}

/// Null if no other library was measured.
std::optional<Chapter> peers_chapter(const Answer& answer, const ReportData& data) {
    if (data.peers.empty() && data.effort.empty()) return std::nullopt;
    Chapter chapter{.id = "peers",
                    .title = "How far are the libraries?",
                    .paragraph = prose("peers.md"),
                    .blocks = {{.grids = {peers_grid(data)}}},
                    .link = "Libraries",
                    .sentence = peers_sentence(answer)};
    for (const std::string& scene : scene_labels(data))
        chapter.blocks.push_back({.title = scene, .grids = {peer_grid(data, scene)}});
    if (!data.effort.empty())
        chapter.blocks.push_back({.title = "What a query takes",
                                  .paragraph = prose("effort.md"),
                                  .grids = {effort_grid(data), effort_floor_grid(data)}});
    return chapter;
}

/// The reference shape in full view, all shapes folded.
Chapter fronts_chapter(const Answer&, const ReportData& data) {
    return {.id = "fronts",
            .title = "How fast, and how exact?",
            .paragraph = prose("fronts.md"),
            .blocks = {{.section = "fronts", .grids = {front_grid(data, reference_shape(data))}},
                       folded(front_grid(data, ""), "All scenes and shapes"),
                       folded(left_out_grid(data), "Timed, and among no points")},
            .link = "Speed and error",
            .sentence = fronts_sentence(data)};
}

Chapter errors_chapter(const Answer&, const ReportData& data) {
    TextGrid summary = error_summary_grid(data);
    drop_zero_columns(summary);
    return {.id = "errors",
            .title = "How wrong are the answers?",
            .paragraph = prose("errors.md"),
            .blocks = {{.grids = {std::move(summary)}}, folded(error_grid(data), "Every cell")},
            .link = "Errors",
            .sentence = errors_sentence(data)};
}

Chapter stability_chapter(const Answer&, const ReportData& data) {
    Chapter chapter{.id = "stability", .title = "Does it hold on hard cases?", .link = "Hard cases"};
    chapter.paragraph = prose(data.stability.empty() ? "no_stability.md" : "stability.md");
    if (data.stability.empty()) return chapter;
    TextGrid summary = stability_summary_grid(data);
    drop_zero_columns(summary);
    chapter.sentence = stability_sentence(data);
    chapter.blocks = {{.section = "stability", .grids = {std::move(summary)}},
                      folded(stability_grid(data), "Family by family")};
    return chapter;
}

TextGrid gaps_grid(const Answer& answer) {
    TextGrid grid{"Figures that were not measured", columns_of("reason|remedy|probes|#figures")};
    for (const Gap& gap : answer.gaps.gaps) {
        std::string probes;
        for (const std::string& probe : gap.probes) append(probes, probe);
        grid.add(gap.reason, gap.remedy.empty() ? "none known" : gap.remedy, probes, gap.figures);
    }
    return grid;
}

Chapter missing_chapter(const Answer& answer, const ReportData&) {
    return {.id = "missing",
            .title = "What was not measured, and how would I get it?",
            .paragraph = prose("missing.md"),
            .blocks = {{.grids = {gaps_grid(answer)}}},
            .link = "Not measured",
            .sentence = gaps_sentence(answer)};
}

Chapter method_chapter(const Answer&, const ReportData& data) {
    TextGrid facts = facts_grid(data), scenes = scenes_grid(data);
    facts.shown_rows = scenes.shown_rows = 40;
    return {.id = "machine",
            .title = "Method, machine and build",
            .paragraph = prose("purpose.md"),
            .blocks = {{.grids = {std::move(facts)}},
                       {.title = "The machine",
                        .grids = machine_grids(input::json_or_null(data.build.machine_json))},
                       folded(std::move(scenes), "Scenes and their parameters")},
            .link = "Method"};
}

Chapter words_chapter(const Answer&, const ReportData& data) {
    return {.id = "words",
            .title = "Words, and each layout",
            .blocks = {{.elements = Glossary(data).list_html()}},
            .link = "Words"};
}

/// Grids without rows are left out, and blocks of nothing else but words about them.
void drop_empty_grids(Chapter& chapter) {
    std::erase_if(chapter.blocks, [](ChapterBlock& block) {
        const auto without_rows = [](const TextGrid& grid) { return grid.rows.empty(); };
        return std::erase_if(block.grids, without_rows) > 0 && block.grids.empty() &&
               block.elements.empty() && block.section.empty();
    });
}

}  // namespace

std::vector<Chapter> report_chapters(const Answer& answer, const ReportData& data,
                                     const std::vector<Chart>& charts) {
    std::vector<Chapter> chapters;
    const auto add = [&](std::initializer_list<Chapter (*)(const Answer&, const ReportData&)> made) {
        for (const auto chapter : made) chapters.push_back(chapter(answer, data));
    };
    add({fronts_chapter, break_even_chapter, bytes_chapter, caches_chapter, body_chapter, times_chapter,
         stability_chapter});
    for (const Addition& addition : additions())
        for (Chapter& chapter : addition.chapters(data, charts)) chapters.push_back(std::move(chapter));
    if (auto chapter = peers_chapter(answer, data)) chapters.push_back(std::move(*chapter));
    if (auto chapter = fields_chapter(data)) chapters.push_back(std::move(*chapter));
    std::ranges::move(study_chapters(data), std::back_inserter(chapters));
    add({layouts_chapter, errors_chapter, counters_chapter, missing_chapter, method_chapter, words_chapter});
    std::ranges::for_each(chapters, drop_empty_grids);
    return chapters;
}

ReportData part_of(const ReportData& data, const std::string& shape, std::optional<bool> own_tables) {
    ReportData part;
    part.meta = data.meta, part.build = data.build, part.scene_files = data.scene_files;
    for (auto cells : {&ReportData::cells, &ReportData::from_files, &ReportData::peers, &ReportData::again})
        for (const ReportCell& cell : data.*cells)
            if ((shape.empty() || cell.shape == shape) &&
                own_tables.value_or(has_own_tables(cell)) == has_own_tables(cell))
                (part.*cells).push_back(cell);
    return part;
}

namespace {

/// Returns what a chapter states of a part of the data; or that it was not measured, and what measures it.
std::string statement(const Chapter& chapter, const Answer& answer) {
    if (!chapter.sentence.empty()) return chapter.sentence;
    const bool modelled = chapter.id == "caches" || chapter.id == "body";
    const std::string body = answer.question.shape ? answer.body_option : "";
    return fmt::format("Not measured. This measures it: edgewise sweep{}{}{}", body,
                       answer.question.own_tables.value_or(false) ? " --scenes pressure" : "",
                       modelled ? " --caches all" : "");
}

}  // namespace

std::string statements_data(const ReportData& data) {
    nlohmann::ordered_json statements = nlohmann::ordered_json::object();
    std::vector<std::string> shapes = {""};
    for (const auto& [vertices, shape] : shapes_by_vertices(data)) shapes.push_back(shape);
    for (const std::string& shape : shapes) {
        for (const auto& [tables, own] : offered_tables) {
            if (shape.empty() && !own) continue;
            const ReportData part = part_of(data, shape, own);
            Question question{.own_tables = own};
            if (!shape.empty()) question.shape = shape;
            const Answer answer = answer_of_scenes(data, question);
            auto& of_part = statements[shape + " " + tables];
            for (const auto made : {fronts_chapter, bytes_chapter, caches_chapter, body_chapter,
                                    times_chapter, layouts_chapter, errors_chapter, counters_chapter})
                if (const Chapter chapter = made(answer, part);
                    chapter.id != "body" || chapter.blocks.empty())
                    of_part[chapter.id] = statement(chapter, answer);
        }
    }
    return input::json_text(statements);
}

std::optional<Chapter> fields_chapter(const ReportData& data) {
    if (data.fields.empty()) return std::nullopt;
    Chapter chapter{.id = "fields",
                    .title = "Which fields travel together?",
                    .paragraph = prose("fields.md"),
                    .blocks = {{.grids = {field_advice_grid(data)}}},
                    .link = "Fields",
                    .sentence = field_verdict(data).substr(1)};
    for (const ReportCell& row : data.fields) {
        if (!row.verified()) continue;
        chapter.blocks.push_back({.elements = "<div class=\"wide\">" + field_picture(row) + "</div>\n",
                                  .grids = {field_groups_grid(row)},
                                  .fold = row.table + ", " + row.algorithm + ": matrix and records"});
    }
    return chapter;
}

}  // namespace edgewise::reports
