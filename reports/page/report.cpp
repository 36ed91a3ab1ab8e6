// SPDX-License-Identifier: MIT
//
// The page is written last: when it is there, what it names is there too.
#include "edgewise/reports/page/report.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <stdexcept>

#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/page/bundles.hpp"
#include "edgewise/reports/page/files.hpp"
#include "edgewise/reports/page/page.hpp"
#include "edgewise/reports/page/paper_figures.hpp"
#include "edgewise/reports/results/wide_results.hpp"

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
            .verified = data.count("verified"),
            .failed = data.count("failed"),
            .unavailable = data.count("unavailable"),
            .build = data.build.id,
            .page = page.string(),
            .charts = charts,
            .pictures = pictures.svg.size(),
            .answer = answer_paragraph(answer_of(data), data),
            .note = !charts                 ? "The chart bundles are missing: the report shows tables only."
                    : pictures.note.empty() ? no_pdf
                                            : pictures.note};
}

}  // namespace

ReportSummary write_report(const std::string& store, const std::string& out_directory,
                           const std::string& bundle_directory) {
    const ReportData data = read_report(store);
    const std::filesystem::path out = out_directory;
    make_directory(out);
    const std::vector<Chart> charts = all_charts(data);
    const std::string scripts = bundle_scripts(bundle_directory);
    const StaticPictures pictures = write_pictures(charts, out, bundle_directory);
    const std::string no_pdf = write_paper_figures(data, charts, pictures, out);
    write_results(data, out);
    write_file(out / "report.md", report_markdown(data, charts, pictures));
    write_file(out / "index.html", page_html(data, charts, pictures, scripts));
    return summary(data, pictures, !scripts.empty(), no_pdf, out / "index.html");
}

}  // namespace edgewise::reports
