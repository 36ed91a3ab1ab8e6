// SPDX-License-Identifier: MIT
//
// The page is written last: when it is there, what it names is there too.
#include "edgewise/reports/page/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "edgewise/input/output_file.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/answer/break_even_map.hpp"
#include "edgewise/reports/answer/decision.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/page/page.hpp"
#include "edgewise/reports/pictures/ranking_pictures.hpp"
#include "edgewise/reports/results/export.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

void make_directory(const std::filesystem::path& out) {
    std::error_code failed;
    std::filesystem::create_directories(out, failed);
    if (failed || !std::filesystem::is_directory(out))
        throw std::runtime_error(fmt::format("cannot create the report's directory {}: {}", out.string(),
                                             failed ? failed.message() : "it is not a directory"));
}

/// The choice of each scene, what it is compared with, and the best GJK.
std::set<std::string> few_tables(const Answer& answer) {
    constexpr std::size_t most = 6;
    std::set<std::string> tables;
    for (const SceneRanking* scene : answer.scenes())
        for (const RankedCell* one :
             {scene->baseline(), scene->choice(), scene->best("gjk"), scene->best("vclip")})
            if (one && tables.size() < most) tables.insert(one->table);
    return tables;
}

/// Writes figures/NAME.svg, or removes an old file if there is no picture now.
void write_picture(const std::string& name, const std::string& svg, const std::filesystem::path& out) {
    const std::filesystem::path file = out / "figures" / (name + ".svg");
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    if (!svg.empty()) input::write_output(file, standalone(svg));
}

}  // namespace

ReportSummary write_report(const std::string& store, const std::string& out_directory,
                           const std::string& bundle_directory) {
    return write_report(read_report(store), out_directory, bundle_directory);
}

ReportSummary write_report(const ReportData& data, const std::string& out_directory,
                           const std::string& bundle_directory, const std::optional<ReportBeside>& beside,
                           const OnReportPart& on_part) {
    const auto begin = [&](const char* part) {
        if (on_part) on_part(part);
    };
    const std::filesystem::path out = out_directory;
    make_directory(out);
    begin("the answer");
    const Answer answer = answer_of(data);
    begin("charts");
    const std::vector<Chart> charts = all_charts(data);
    const std::string bundles = bundle_elements(bundle_directory);
    begin("pictures");
    const StaticPictures pictures = write_pictures(charts, few_tables(answer), out, bundle_directory);
    const std::string no_pdf = write_cited_figures(data, charts, pictures, out);
    begin("results");
    write_results(data, out);
    std::string picture;  // of the first scene that has one
    for (const SceneRanking* scene : answer.scenes())
        if (picture.empty()) picture = time_bytes_svg(*scene);
    write_picture("answer", picture, out);
    write_picture("break_even", break_even_svg(break_even_map(data, answer.question.error_limit)), out);
    begin("chapters");
    std::vector<Chapter> chapters = report_chapters(answer, data, charts);
    std::string changes;
    if (beside) {
        chapters.insert(chapters.begin(), compare_chapter(*beside->comparison, beside->slack, beside->name));
        changes = chapter_markdown(chapters.front());
    }
    begin("pages");
    input::write_output(out / "report.md", report_markdown(data, answer, pictures, changes));
    input::write_output(out / "index.html", page_html(data, answer, chapters, charts, pictures, bundles));
    const std::string& no_picture = pictures.note.empty() ? no_pdf : pictures.note;
    return {answer.counts, (out / "index.html").string(), terminal_text(answer, data),
            bundles.empty() ? "The chart bundles are missing: the report shows tables only." : no_picture};
}

// The report in short, as Markdown: what a person pastes into a pull request or a thesis. The page has the
// rest.

namespace {

constexpr std::size_t few_rows = 6;

std::string headed(const std::string& title) { return "## " + title + "\n\n"; }

std::string list(const std::vector<std::string>& items) {
    std::string out;
    for (const std::string& item : items) out += "- " + markdown_text(item) + "\n";
    return out.empty() ? out : out + "\n";
}

/// The decision table, what would change it, and what it holds for.
std::string decisions_markdown(const ReportData& data, const Answer& answer) {
    const DecisionTable table =
        Decisions(data, {.error_limit = answer.question.error_limit}).table(answer.question.error_limit);
    TextGrid grid{"", columns_of("body|shared table|a table each")};
    for (const DecisionRow& row : table.rows)
        grid.add(fmt::format("{} ({} vertices)", row.shape, row.vertices), row.shared.text(), row.own.text());
    const AnswerText text = answer_text(answer, data);
    return fmt::format("**{}**\n\n{}{}{}{} {} {}\n\n", markdown_text(table.sentence), grid_markdown(grid),
                       table.changes.empty() ? "" : "What would change this:\n\n", list(table.changes),
                       markdown_text(text.conditions), markdown_text(text.noise), markdown_text(text.counts));
}

/// Total and the paper's subtotal of the tables of one shape: the smallest, and the paper's layout.
std::string bytes_markdown(const ReportData& data, const Answer& answer) {
    TextGrid all = bytes_grid(data, reference_shape(data));
    TextGrid few{fmt::format("{}: bytes per edge of whole tables, smallest first, and the paper's layout",
                             reference_shape(data)),
                 columns_of("algorithm|table type|#total|#paper's subtotal (slope)|#table, bytes")};
    const std::size_t total = all.columns.size() - 4;
    std::ranges::stable_sort(all.rows, [&](const auto& a, const auto& b) {
        return a[total].why.empty() && b[total].why.empty() &&
               std::stod(a[total].text) < std::stod(b[total].text);
    });
    for (const auto& row : all.rows) {
        if (few.rows.size() < few_rows - 1 || answer.baseline.is(row[0].text, row[1].text))
            few.rows.push_back({row[0], row[1], row[total], row[total + 1], row[total + 3]});
    }
    return grid_markdown(few);
}

std::string fronts_markdown(const Answer& answer) {
    std::string out;
    for (const SceneRanking* scene : answer.scenes()) {
        std::string names;
        for (const std::size_t i : front_of_time_and_bytes(*scene))
            append(names, mark_text(scene->cells[i]), "; ");
        if (!names.empty())
            out += fmt::format("- {}, {}: {}\n", markdown_text(scene->label), markdown_text(scene->shape),
                               markdown_text(names));
        if (std::count(out.begin(), out.end(), '\n') == static_cast<long>(most_answer_rows)) break;
    }
    return out.empty() ? out : headed("On the front of time and bytes") + out + "\n";
}

/// The map as a table of a few bodies.
std::string break_even_markdown(const ReportData& data, const Answer& answer) {
    constexpr std::size_t few_bodies = 4;
    const BreakEvenMap map = break_even_map(data, answer.question.error_limit);
    if (map.measured() == 0) return {};
    return headed("Who wins where") + markdown_text(break_even_sentence(map)) + "\n\n" +
           grid_markdown(break_even_grid(map, few_bodies));
}

std::string problems_markdown(const ReportData& data) {
    TextGrid problems = problems_grid(data);
    if (problems.rows.empty()) return {};
    const std::size_t all = problems.rows.size();
    if (all > few_rows) problems.rows.resize(few_rows);
    return headed("Failed and unavailable cells") +
           (all > few_rows ? fmt::format("The first {} of {}; results/ has them all.\n\n", few_rows, all)
                           : "") +
           grid_markdown(problems);
}

std::string repeat_markdown(const ReportData& data, const Answer& answer) {
    std::string out;
    for (const SweepRun& run : answer.runs)
        out += fmt::format("    edgewise {}    # {}{}\n", run.command, run.started,
                           run.finished() ? "" : ", not finished");
    if (out.empty()) out = "    layouts/sweep    # the store does not say with which options\n";
    out += "    " + measuring_command(answer) + "\n\n";
    return out + fmt::format("{}; {} {}, {}; revision {}.\n", machine_text(data),
                             markdown_text(data.build.compiler), data.build.build_type,
                             markdown_text(data.build.flags), data.build.git_revision);
}

}  // namespace

std::string chapter_markdown(const Chapter& chapter) {
    std::string out = headed(markdown_text(chapter.title)) +
                      markdown_text(chapter.sentence.empty() ? chapter.paragraph : chapter.sentence) + "\n\n";
    for (const ChapterBlock& block : chapter.blocks) {
        for (TextGrid grid : block.grids) {
            if (grid.rows.size() > few_rows && grid.rows.size() > grid.shown_rows) {
                append(grid.caption, fmt::format("the first {} of {}", few_rows, grid.rows.size()));
                grid.rows.resize(few_rows);
            }
            out += grid_markdown(grid);
        }
    }
    return out;
}

std::string report_markdown(const ReportData& data, const Answer& answer, const StaticPictures& pictures,
                            const std::string& changes) {
    std::string out = "# Which layout, and what does it cost?\n\n" + decisions_markdown(data, answer);
    out += grid_markdown(answer_grid(answer)) + problems_markdown(data) + changes;
    const std::string fronts = fronts_markdown(answer);
    if (!fronts.empty()) out += "![Time against bytes](figures/answer.svg)\n\n";
    if (!pictures.note.empty()) out += markdown_text(pictures.note) + "\n\n";
    out += fronts;
    out += break_even_markdown(data, answer);
    out += headed("Bytes") + bytes_markdown(data, answer);
    for (const Chapter& chapter : study_chapters(data)) out += chapter_markdown(chapter);
    out += headed("What passed") + list(what_passed(answer));
    out += headed("Method") + std::string(report_text("method.md")) + "\n";
    return out + headed("How to repeat") + repeat_markdown(data, answer);
}

}  // namespace edgewise::reports
