// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/answer/decision.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/pictures/ranking_pictures.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
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
    if (!scene.recommends()) return "nothing is recommended; " + scene.why_not();
    if (scene.too_noisy()) return "too noisy to choose by; " + choice.name();
    if (scene.beats_baseline) return choice.name();
    return &choice == scene.baseline() ? "nothing beats the paper's layout"
                                       : fmt::format("nothing beats the paper's layout; {}", choice.name());
}

AnswerRow row_of(const SceneRanking& scene) {
    AnswerRow row;
    const RankedCell* choice = scene.choice();
    if (!choice) {
        row.take = "nothing is known to be within the error";
        return row;
    }
    const RankedCell *gjk = scene.best("gjk"), *baseline = scene.baseline();
    row.take = take_of_scene(scene, *choice), row.tie_set = tie_set_text(scene);
    row.ratio = ratio_text(*choice);
    const bool inexact =
        std::ranges::any_of(scene.cells, [](const RankedCell& one) { return one.cell->algorithm == "gjk"; });
    row.of_gjk = gjk       ? fmt::format("{:.2f}", choice->ratio / gjk->ratio)
                 : inexact ? "over the error"
                           : "not measured";
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
    std::string html = fmt::format(
        "<tr class=\"{0}\" data-scene=\"{1}\"><th scope=\"row\">{1}<br><small>{2}{3}</small></th>"
        "<td><b>{4}</b>{5}</td>",
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

std::string answer_rows_html(const Answer& answer) {
    std::vector<const SceneRanking*> scenes = answer.scenes();
    if (scenes.empty()) return {};
    const std::size_t all = scenes.size();
    if (scenes.size() > most_answer_rows) scenes.resize(most_answer_rows);
    const StripAxis axis = strip_axis(scenes);
    std::string rows;
    for (const SceneRanking* scene : scenes) rows += row_html(*scene, axis, answer.shape);
    std::string key = prose("answer_key.md");
    if (all > scenes.size())
        key += fmt::format(" Among all cells: {} more.", plural(all - scenes.size(), "scene"));
    return fmt::format(fmt::runtime(report_text("page.answer.html")),
                       fmt::arg("limit", limit_text(answer.question.error_limit)),
                       fmt::arg("axis", strip_head_svg(axis)), fmt::arg("rows", rows)) +
           html_paragraph(key, "note");
}

}  // namespace

TextGrid answer_grid(const Answer& answer) {
    TextGrid grid{
        "", columns_of("scene|body|tables|take|fastest|#time / paper's|#time / best GJK|#bytes per edge|"
                       "#lines per query|#worst error")};
    for (const SceneRanking* scene : answer.scenes()) {
        if (grid.rows.size() == most_answer_rows) {
            grid.caption = fmt::format("the first {} of {} scenes", most_answer_rows, answer.scenes().size());
            break;
        }
        const AnswerRow row = row_of(*scene);
        grid.add(scene->label, scene->shape, scene->own_tables ? "each" : "shared", row.take, row.tie_set,
                 row.ratio, row.of_gjk, row.bytes, row.lines, row.error);
    }
    return grid;
}

namespace {

std::string title_of(double error_limit) {
    return fmt::format("Which layout, and what does it cost? — error at most {} of the bodies' size",
                       limit_text(error_limit));
}

std::string decision_cell_html(const Decision& decision, const char* group) {
    std::string html =
        fmt::format("<td class=\"{}\"><b>{}</b>", group,
                    html_text(decision.take.empty() ? "nothing is recommended" : decision.take));
    for (const std::string& fact : decision.facts)  // the worst error next to the bytes
        html += (fact.starts_with("worst error") ? " · " : "<br>") + html_text(fact);
    return html + "</td>";
}

/// The sentence, a row for each body, and below what would change them.
std::string decisions_html(const DecisionTable& table) {
    std::string rows;
    for (const DecisionRow& row : table.rows)
        rows += fmt::format("<tr><th scope=\"row\">{}<br><small>{} vertices</small></th>{}{}</tr>\n",
                            html_text(row.shape), row.vertices, decision_cell_html(row.shared, "shared"),
                            decision_cell_html(row.own, "own"));
    return fmt::format(fmt::runtime(report_text("page.decision.html")),
                       fmt::arg("sentence", html_text(table.sentence)), fmt::arg("rows", rows),
                       fmt::arg("changes", (table.changes.empty() ? "" : "<p>What would change this:</p>\n") +
                                               html_list(table.changes, "changes")));
}

std::string runs_text(const std::vector<SweepRun>& runs) {
    std::string text;
    for (const SweepRun& run : runs) {
        append(text,
               fmt::format("edgewise {} ({}{})", run.command, run.started,
                           run.finished() ? "" : ", not finished"),
               "; ");
    }
    return text.empty() ? "date and command are not in this store" : text;
}

std::string provenance(const Answer& answer, const ReportData& data) {
    return fmt::format("{} · {} {} · revision {} · plan {}, seed {} · {}", machine_text(data),
                       data.build.compiler, data.build.build_type, data.build.git_revision.substr(0, 12),
                       data.meta_value("plan").value_or(""), data.meta_value("seed").value_or(""),
                       runs_text(answer.runs));
}

/// Returns the options for the scenes, each with its tables and number of bodies.
std::string scene_options(const ReportData& data) {
    std::string options = html_option("", "all", true);
    const std::vector<const ReportCell*> cells = data.swept();
    for (const std::string& label : scene_labels(data)) {
        const ReportCell& cell = **std::ranges::find(cells, label, &ReportCell::scene_label);
        options += fmt::format("<option value=\"{0}\" data-tables=\"{1}\" data-bodies=\"{2}\">{0}</option>",
                               html_text(label), has_own_tables(cell) ? "own" : "shared",
                               parameter_of(cell, "bodies").value_or(0));
    }
    return options;
}

/// The page's one bar: the question, and what charts and tables show. Only shown where scripts run.
std::string question_bar(const Answer& answer, const ReportData& data) {
    const std::string all = html_option("", "all", true);
    std::string shapes = all, limits, algorithms = all, precisions = all;
    std::set<std::string> of_algorithms, of_precisions;
    for (const ReportCell* cell : data.swept())
        of_algorithms.insert(cell->algorithm), of_precisions.insert(cell->precision);
    for (const auto& [vertices, shape] : shapes_by_vertices(data))
        shapes += html_option(shape, fmt::format("{} ({})", vertices, shape));
    for (const double limit : offered_limits)
        limits += html_option(limit_text(limit), limit_text(limit), limit == answer.question.error_limit);
    for (const std::string& name : of_algorithms) algorithms += html_option(name, algorithm_title(name));
    for (const std::string& name : of_precisions) precisions += html_option(name, name);
    const std::string tables =
        html_option("both", "either", true) + html_option("own", "yes") + html_option("shared", "no");
    return fmt::format(fmt::runtime(report_text("page.question.html")),
                       fmt::arg("shape", html_select("ask-shape", "body", shapes)),
                       fmt::arg("tables", html_select("ask-tables", "a table each", tables)),
                       fmt::arg("limit", html_select("ask-limit", "error at most", limits)),
                       fmt::arg("scene", html_select("ask-scene", "scene", scene_options(data))),
                       fmt::arg("algorithm", html_select("ask-algorithm", "algorithm", algorithms)),
                       fmt::arg("precision", html_select("ask-precision", "precision", precisions)),
                       fmt::arg("command", html_text(measuring_command(answer))));
}

/// Returns one picture for each group of scenes: that of its first scene with a cell on the front.
std::string pictures_of(const Answer& answer) {
    std::string html;
    for (const auto* scenes : {&answer.shared, &answer.own}) {
        for (const SceneRanking& scene : *scenes) {
            const std::string svg = time_bytes_svg(scene);
            if (svg.empty()) continue;
            html += fmt::format("<figure class=\"{}\">{}<figcaption>{} ({})</figcaption></figure>\n",
                                scene.own_tables ? "own" : "shared", svg, html_text(scene.label),
                                scene.own_tables ? "a table for each body" : "one shared table");
            break;
        }
    }
    return html.empty() ? html : "<div class=\"pictures\">" + html + "</div>\n";
}

std::string problems_of(const ReportData& data) {
    const TextGrid problems = problems_grid(data);
    if (problems.rows.empty()) return {};
    TextGrid shown = problems;
    constexpr std::size_t most = 12;
    if (shown.rows.size() > most) {
        shown.rows.resize(most);
        shown.caption = fmt::format("The first {} of {}; results/ has them all", most, problems.rows.size());
    }
    return html_heading("problems",
                        data.any_failed() ? "Failed and unavailable cells" : "Unavailable cells") +
           grid_html(shown);
}

std::string counts_html(const Answer& answer, const AnswerText& text, const ReportData& data) {
    const bool failed = data.any_failed();
    const bool partly = any_unfinished(answer.runs) || answer.counts.unavailable > 0;
    return fmt::format(
        "<p class=\"verdict {}\">{} <a href=\"#missing\">What is missing, and how to get "
        "it</a>.</p>\n",
        failed   ? "bad"
        : partly ? "part"
                 : "good",
        html_text(text.counts));
}

}  // namespace

std::string answer_html(const Answer& answer, const DecisionTable& table, const ReportData& data) {
    const AnswerText text = answer_text(answer, data);
    std::string html = decisions_html(table) + html_paragraph(text.conditions + " " + text.noise, "note");
    if (answer.scenes().empty()) return html;
    return html + fmt::format("<details class=\"contest\"><summary>{}</summary>\n{}{}</details>\n",
                              html_text("All contenders, scene by scene: " + answer.shape),
                              answer_rows_html(answer), pictures_of(answer));
}

std::string first_screen_html(const Answer& answer, const ReportData& data) {
    const double limit = answer.question.error_limit;
    std::string html = fmt::format("<h1>{}</h1>\n", html_text(title_of(limit)));
    html += question_bar(answer, data);
    html += fmt::format("<section id=\"answer\" aria-live=\"polite\">\n{}</section>\n",
                        answer_html(answer, Decisions(data).table(limit), data));
    html += counts_html(answer, answer_text(answer, data), data);
    html += html_paragraph(provenance(answer, data), "note") + problems_of(data);
    return html + html_heading("passed", "What passed") + html_list(what_passed(answer), "passed");
}

namespace {

/// Returns the questions on tables that the bar offers: both kinds, shared ones, a table each; and both kinds
/// and a table each for every number of bodies that was measured, and for none of them (0).
std::vector<Question> offered_questions(const ReportData& data) {
    std::set<double> bodies_measured = {0};
    for (const ReportCell* cell : data.swept())
        if (has_own_tables(*cell)) bodies_measured.insert(parameter_of(*cell, "bodies").value_or(0));
    std::vector<Question> questions = {{}, {.own_tables = false}, {.own_tables = true}};
    for (const double bodies : bodies_measured)
        questions.push_back({.bodies = bodies}), questions.push_back({.own_tables = true, .bodies = bodies});
    return questions;
}

std::string question_key(const std::string& shape, const Question& question) {
    const auto& [tables, own] =
        *std::ranges::find(offered_tables, question.own_tables, [](const auto& of) { return of.second; });
    const std::string bodies = question.bodies ? fmt::format("{}", *question.bodies) : "";
    return fmt::format("{} {} {} {}", shape, limit_text(question.error_limit), tables, bodies);
}

}  // namespace

std::string answers_data(const ReportData& data) {
    nlohmann::ordered_json answers = nlohmann::ordered_json::object();
    DistinctTexts lines;  // most are in several answers
    std::vector<std::string> shapes = {""};
    for (const auto& [vertices, shape] : shapes_by_vertices(data)) shapes.push_back(shape);
    for (Question question : offered_questions(data)) {
        const Decisions decisions(data, question);
        for (const std::string& shape : shapes) {
            if (!shape.empty()) question.shape = shape;
            for (const double limit : offered_limits) {
                question.error_limit = limit;
                const Answer answer = answer_of_scenes(data, question);
                nlohmann::ordered_json html = nlohmann::ordered_json::array();
                std::istringstream text(answer_html(answer, decisions.table(limit, shape), data));
                for (std::string line; std::getline(text, line);) html.push_back(lines.place(line));
                answers[question_key(shape, question)] = {
                    {"title", title_of(limit)}, {"command", measuring_command(answer)}, {"html", html}};
            }
        }
    }
    return input::json_text(nlohmann::ordered_json{{"lines", lines.texts()}, {"answers", answers}});
}

}  // namespace edgewise::reports
