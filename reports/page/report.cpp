// SPDX-License-Identifier: MIT
//
// The page is written last: when it is there, what it names is there too.
#include "edgewise/reports/page/report.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <set>
#include <stdexcept>

#include "edgewise/input/output_file.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/page/page.hpp"
#include "edgewise/reports/page/pictures.hpp"
#include "edgewise/reports/pictures/ranking_pictures.hpp"
#include "edgewise/reports/results/export.hpp"

namespace edgewise::reports {

namespace {

void make_directory(const std::filesystem::path& out) {
    std::error_code failed;
    std::filesystem::create_directories(out, failed);
    if (failed || !std::filesystem::is_directory(out))
        throw std::runtime_error(fmt::format("cannot create the report's directory {}: {}", out.string(),
                                             failed ? failed.message() : "it is not a directory"));
}

/// `no_pdf`: why PDFs are missing.
ReportSummary summary(const ReportData& data, const StaticPictures& pictures, bool charts,
                      const std::string& no_pdf, const std::filesystem::path& page) {
    return {.cells = data.cell_count(),
            .verified = data.count(store::CellStatus::verified),
            .failed = data.count(store::CellStatus::failed),
            .unavailable = data.count(store::CellStatus::unavailable),
            .build = data.build.id,
            .page = page.string(),
            .charts = charts,
            .pictures = pictures.svg.size(),
            .note = !charts                 ? "The chart bundles are missing: the report shows tables only."
                    : pictures.note.empty() ? no_pdf
                                            : pictures.note};
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

/// Returns the picture of the first scene that has one.
std::string answer_picture(const Answer& answer) {
    for (const SceneRanking* scene : answer.scenes())
        if (std::string svg = time_bytes_svg(*scene); !svg.empty()) return svg;
    return {};
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
    write_picture("answer", answer_picture(answer), out);
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
    ReportSummary made = summary(data, pictures, !bundles.empty(), no_pdf, out / "index.html");
    made.answer = terminal_text(answer, data);
    return made;
}

}  // namespace edgewise::reports
