// SPDX-License-Identifier: MIT
//
// Three kinds of chapters: of studies that the report does not know, which the store describes
// (sweep/study.hpp); the map of winners; and what changed since another store.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/answer/break_even_map.hpp"
#include "edgewise/reports/answer/decision.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/page/page.hpp"
#include "edgewise/reports/pictures/ranking_pictures.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/text/report_text.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

using StudyJson = nlohmann::json;

/// Returns a member if it has the type of `otherwise`, else that: another program may have written the store.
template <class Value>
Value member(const StudyJson& object, const char* name, const Value& otherwise) {
    const StudyJson value = input::member_of(object, name);
    const bool fits = StudyJson(otherwise).is_number() ? value.is_number() : value.is_string();
    return fits ? value.get<Value>() : otherwise;
}

/// Returns a row for each cell, with the figures that the chapter's columns name.
TextGrid study_grid(const std::vector<const ReportCell*>& cells, const StudyJson& columns) {
    TextGrid grid =
        cell_grid("", "scene|shape|algorithm|table type|status", std::vector<FigureColumn>(), cells);
    for (const StudyJson& column : columns) {
        const std::string figure = member<std::string>(column, "figure", "");
        const std::size_t dot = std::min(figure.find('.'), figure.size());
        const double unit = member(column, "unit", 1.0);
        grid.columns.push_back({member(column, "title", figure), true});
        for (std::size_t i = 0; i < cells.size(); ++i)
            grid.rows[i].push_back(figure_cell(
                cells[i]->figure(figure.substr(0, dot), figure.substr(std::min(dot + 1, figure.size()))),
                unit > 0 ? unit : 1));
    }
    return grid;
}

/// How differently two scenes move, by rows of the study `coherence`: a factor of ten in turn or way counts
/// as much as a third of all pairs that overlap or are near. Infinite if a figure is missing.
double motion_distance(const ReportCell& a, const ReportCell& b) {
    constexpr double least = 1e-7, of_shares = 3;
    double sum = 0;
    const auto add = [&](const char* name, const auto& apart) {
        const auto of_a = a.figure("coherence", name).value, of_b = b.figure("coherence", name).value;
        const double one = of_a && of_b ? apart(*of_a, *of_b) : std::numeric_limits<double>::infinity();
        sum += one * one;
    };
    for (const char* name : {"turn_median", "turn_p90", "way_median"})
        add(name, [&](double x, double y) { return std::log10(std::max(x, least) / std::max(y, least)); });
    for (const char* name : {"overlapping", "near", "very_near"})
        add(name, [&](double x, double y) { return of_shares * (x - y); });
    return sum;
}

/// Names the invented scene, with tables shared the same way, that moves most like each recorded one.
std::string nearest_motions(const std::vector<const ReportCell*>& cells) {
    std::string text;
    const auto is_recorded = [](const ReportCell* cell) {
        return parameter_of(*cell, "recording").has_value();
    };
    for (const ReportCell* recorded : cells) {
        if (!is_recorded(recorded)) continue;
        const ReportCell* nearest = nullptr;
        double least = std::numeric_limits<double>::infinity();
        for (const ReportCell* invented : cells) {
            if (is_recorded(invented) || has_own_tables(*invented) != has_own_tables(*recorded)) continue;
            const double apart = motion_distance(*recorded, *invented);
            if (apart < least) least = apart, nearest = invented;
        }
        if (!nearest) continue;
        store::CellRow scene = *nearest;
        scene.run = store::sweep_run;
        append(text, fmt::format("{} moves most like {}", recorded->scene, scene_label(scene)), "; ");
    }
    return text.empty() ? text : text + ".";
}

}  // namespace

std::vector<Chapter> study_chapters(const ReportData& data) {
    std::map<std::string, std::vector<const ReportCell*>> studies;
    for (const ReportCell& cell : data.other_studies) studies[cell.run].push_back(&cell);
    std::vector<Chapter> chapters;
    for (const auto& [name, cells] : studies) {
        const StudyJson about = input::json_or_null(data.meta_value(store::study_key + name).value_or(""));
        const StudyJson columns = input::member_of(about, "columns");
        Chapter& chapter = chapters.emplace_back();
        chapter.id = "study-" + name;  // as the page's links have it
        for (char& c : chapter.id)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
        chapter.title = member(about, "title", name);
        chapter.paragraph =
            member<std::string>(about, "text", "The store does not describe the figures of this study.");
        chapter.blocks = {{.grids = {study_grid(cells, columns.is_array() ? columns : StudyJson::array())}}};
        chapter.link = name;
        if (name == "coherence") chapter.sentence = nearest_motions(cells);
    }
    return chapters;
}

namespace {

/// The map and where its winner changes.
std::string break_even_html(const BreakEvenMap& map) {
    if (map.measured() == 0)
        return html_paragraph("No scene of this store was timed in the same rounds as the baseline.", "note");
    std::string html = html_paragraph(break_even_sentence(map), "sentence");
    html += "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"Who wins where, as a picture\">" +
            break_even_svg(map) + "</div>\n";
    html += html_paragraph(fmt::format("Within an error of {}.", limit_text(map.error_limit)), "note");
    return html + html_list(break_even_lines(map), "findings");
}

/// What the map has no room or no place for.
std::string left_out_text(const BreakEvenMap& map) {
    std::string text;
    if (map.columns_left_out > 0)
        append(text, plural(map.columns_left_out, "body", "bodies") + " of fewer scenes are left out", "; ");
    if (map.bodies_not_timed > 0)
        append(text, fmt::format("of {} nothing was timed", plural(map.bodies_not_timed, "body", "bodies")),
               "; ");
    if (map.scenes_left_out > 0)
        append(text,
               fmt::format("{} without a turn or a number of tables {} no place",
                           plural(map.scenes_left_out, "scene"), map.scenes_left_out == 1 ? "has" : "have"),
               "; ");
    return text.empty() ? text : text + ".";
}

}  // namespace

Chapter break_even_chapter(const Answer& answer, const ReportData& data) {
    const BreakEvenMap map = break_even_map(data, answer.question.error_limit);
    Chapter chapter{
        .id = "map",
        .title = "From how many vertices, at which coherence and working set, does which layout win?",
        .paragraph = prose("break_even.md"),
        .link = "Who wins where"};
    chapter.blocks.push_back({.elements = "<div id=\"break-even\">" + break_even_html(map) + "</div>\n"});
    if (const std::string left_out = left_out_text(map); !left_out.empty())
        chapter.blocks.push_back({.paragraph = left_out});
    if (map.measured() > 0)
        chapter.blocks.push_back({.grids = {break_even_grid(map)}, .fold = "Every place as a table"});
    chapter.blocks.push_back({.paragraph = prose("break_even_plan.md")});
    return chapter;
}

std::string break_even_data(const ReportData& data) {
    nlohmann::ordered_json maps = nlohmann::ordered_json::object();
    std::vector<std::string> shapes = {""};
    for (const auto& [vertices, shape] : shapes_by_vertices(data)) shapes.push_back(shape);
    for (const std::string& shape : shapes) {
        for (const auto& [tables, own] : offered_tables) {
            const ReportData part = part_of(data, shape, own);
            for (const double limit : offered_limits)
                maps[fmt::format("{} {} {}", shape, limit_text(limit), tables)] =
                    break_even_html(break_even_map(part, limit));
        }
    }
    return input::json_text(maps);
}

namespace {

using measure::Outcome;

std::string shown_value(const measure::RecordRow& row) {
    return row.has_interval ? fmt::format("{:.3f} [{:.3f}, {:.3f}]", row.value, row.low, row.high)
                            : fmt::format("{:.6g}", row.value);
}

std::string change_text(const measure::ComparedRow& row) {
    if (!(row.was.value > 0)) return "from 0";
    return row.is.has_interval
               ? fmt::format("{:.3f} [{:.3f}, {:.3f}]", row.change(), row.least_change(), row.most_change())
               : fmt::format("{:.3f}", row.change());
}

/// Rows of one outcome, in the comparison's order.
TextGrid rows_grid(const char* title, const measure::RecordComparison& found, Outcome outcome) {
    TextGrid grid{title, columns_of("figure|#before|#after|#after / before|made of|cell")};
    for (const measure::ComparedRow& row : found.rows)
        if (row.outcome == outcome)
            grid.add(row.is.figure, shown_value(row.was), shown_value(row.is), change_text(row), row.note,
                     row.is.cell);
    return grid;
}

TextGrid conditions_grid(const measure::RecordComparison& found) {
    TextGrid grid{"What else differs, and may be the cause", columns_of("what|before|after|as a cause")};
    for (const measure::ComparedCondition& condition : found.conditions)
        grid.add(condition.what, condition.was, condition.is, condition.same() ? "excluded" : "possible");
    grid.shown_rows = grid.rows.size();
    return grid;
}

}  // namespace

Chapter compare_chapter(const StoreComparison& comparison, double slack, const std::string& other) {
    const measure::RecordComparison& found = comparison.found;
    Chapter chapter{
        .id = "changes",
        .title = "What changed since " + other + "?",
        .paragraph =
            prose("comparison.md", fmt::arg("slack", 100 * slack),
                  fmt::arg("noise_low", comparison.noise_low), fmt::arg("noise_high", comparison.noise_high)),
        .link = "What changed",
        .sentence = fmt::format(
            "{} of {} figures in both stores became worse, {} better; {} cells or figures are missing, {} new.",
            found.count(Outcome::worse), found.compared(), found.count(Outcome::better),
            found.count(Outcome::missing), found.count(Outcome::added))};
    for (auto& [title, outcome] : {std::pair("Worse", Outcome::worse), std::pair("Better", Outcome::better)})
        if (TextGrid grid = rows_grid(title, found, outcome); !grid.rows.empty())
            chapter.blocks.push_back({.grids = {std::move(grid)}});
    chapter.blocks.push_back({.grids = {conditions_grid(found)}});
    return chapter;
}

}  // namespace edgewise::reports
