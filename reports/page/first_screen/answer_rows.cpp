// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/first_screen/answer_rows.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/pictures/strip.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

/// Contents of one row; `why` has the reason if there is no number.
struct AnswerRow {
    std::string take, tie_set;
    std::string ratio, of_gjk, bytes, bytes_beside, lines, lines_beside, error;
};

std::string or_not_measured(const std::optional<double>& value, const std::string& unit = {}) {
    return value ? number_text(*value, unit) : "not measured";
}

std::string beside(const std::optional<double>& value, const std::string& unit = {}) {
    return value ? "paper's " + number_text(*value, unit) : "";
}

std::string take_of_scene(const SceneRanking& scene, const RankedCell& choice) {
    std::string missing;
    for (const std::string& cell : scene.not_measured) append(missing, cell);
    if (!missing.empty()) return fmt::format("nothing is recommended; not measured: {}", missing);
    if (scene.beats_baseline) return choice.name();
    if (scene.too_noisy) return fmt::format("too noisy to choose by; {}", choice.name());
    return &choice == scene.baseline() ? "nothing beats the paper's layout"
                                       : fmt::format("nothing beats the paper's layout; {}", choice.name());
}

AnswerRow row_of(const SceneRanking& scene) {
    AnswerRow row;
    const RankedCell* choice = scene.choice();
    if (!choice) {
        row.take = "nothing is within the error";
        return row;
    }
    const RankedCell *gjk = scene.best("gjk"), *baseline = scene.baseline();
    row.take = take_of_scene(scene, *choice), row.tie_set = tie_set_text(scene);
    row.ratio = ratio_text(*choice);
    row.of_gjk = gjk ? fmt::format("{:.2f}", choice->ratio / gjk->ratio) : "not measured";
    row.bytes = or_not_measured(choice->bytes_per_edge, "B/edge");
    row.lines = or_not_measured(choice->lines_per_query);
    row.error = or_not_measured(choice->worst_error, "scale");
    if (baseline && baseline != choice) {
        row.bytes_beside = beside(baseline->bytes_per_edge, "B/edge");
        row.lines_beside = beside(baseline->lines_per_query);
    }
    return row;
}

std::string number_html(const std::string& title, const std::string& text, const std::string& small = {}) {
    return fmt::format("<td class=\"number\" data-title=\"{}\">{}{}</td>", title, html_text(text),
                       small.empty() ? "" : "<br><small>" + html_text(small) + "</small>");
}

/// A long tie set is folded after its count.
std::string tie_set_html(const std::string& text) {
    const std::size_t end = text.find(" tie: ");
    if (end == text.npos) return "<br><small>" + html_text(text) + "</small>";
    return fmt::format("<details class=\"ties\"><summary>{} tie</summary>{}</details>", text.substr(0, end),
                       html_text(text.substr(end + 6)));
}

std::string row_html(const SceneRanking& scene, const StripAxis& axis, const std::string& shape) {
    const AnswerRow row = row_of(scene);
    std::string html =
        fmt::format("<tr class=\"{}\"><th scope=\"row\">{}<br><small>{}{}</small></th><td><b>{}</b>{}</td>",
                    scene.own_tables ? "own" : "shared", html_text(scene.label), html_text(scene.sentence),
                    scene.shape == shape ? "" : html_text("; " + scene.shape), html_text(row.take),
                    tie_set_html(row.tie_set));
    html += fmt::format(
        "<td class=\"strips\">{}<span class=\"ratio\" data-title=\"time / paper's\">{}</span></td>",
        strip_svg(scene, axis), html_text(row.ratio));
    html += number_html("time / best GJK", row.of_gjk);
    html += number_html("bytes per edge", row.bytes, row.bytes_beside);
    html += number_html("lines per query", row.lines, row.lines_beside);
    return html + number_html("worst error", row.error) + "</tr>\n";
}

}  // namespace

std::string answer_rows_html(const Answer& answer) {
    std::vector<const SceneRanking*> scenes = answer.scenes();
    if (scenes.empty()) return {};
    const std::size_t all = scenes.size();
    if (scenes.size() > most_answer_rows) scenes.resize(most_answer_rows);
    const StripAxis axis = strip_axis(scenes);
    std::string rows;
    for (const SceneRanking* scene : scenes) rows += row_html(*scene, axis, answer.shape);
    std::string key = prose("answer_key.md");
    if (all > scenes.size()) key += fmt::format(" {} more scenes are among all cells.", all - scenes.size());
    return fmt::format(fmt::runtime(report_text("page.answer.html")),
                       fmt::arg("limit", limit_text(answer.question.error_limit)),
                       fmt::arg("axis", strip_head_svg(axis)), fmt::arg("rows", rows)) +
           html_paragraph(key, "note");
}

TextGrid answer_grid(const Answer& answer) {
    TextGrid grid{"",
                  columns_of("scene|tables|take|fastest|#time / paper's|#time / best GJK|#bytes per edge|"
                             "#lines per query|#worst error"),
                  {}};
    for (const SceneRanking* scene : answer.scenes()) {
        if (grid.rows.size() == most_answer_rows) break;
        const AnswerRow row = row_of(*scene);
        grid.rows.push_back(grid_row(scene->label, scene->own_tables ? "each" : "shared", row.take,
                                     row.tie_set, row.ratio, row.of_gjk, row.bytes, row.lines, row.error));
    }
    return grid;
}

}  // namespace edgewise::reports
