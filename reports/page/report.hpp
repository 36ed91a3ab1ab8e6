// SPDX-License-Identifier: MIT
//
// The report generator's one entry: a store in, a directory of readable files out.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "edgewise/reports/answer/answer.hpp"

namespace edgewise::reports {

struct StoreComparison;

struct ReportSummary : CellCounts {
    std::string page;    ///< path of index.html
    std::string answer;  ///< which layout to take, and the tie set of each scene
    std::string note;    ///< what is missing and what to do; empty when nothing is
};

/// Another store that the report is held against.
struct ReportBeside {
    const StoreComparison* comparison;  ///< what changed since it
    double slack;                       ///< a time may become longer by this part of itself
    std::string name;
};

/// Reads `store` and writes index.html, report.md, results/ and figures/ into `out_directory`.
/// `bundle_directory` holds the chart bundles and render_svg.mjs; it may be missing. The same store gives the
/// same bytes. Throws std::runtime_error with one line: what, where, what to do.
ReportSummary write_report(const std::string& store, const std::string& out_directory,
                           const std::string& bundle_directory);

/// The number of parts of a report; each part is announced when it begins.
inline constexpr std::size_t report_parts = 6;
using OnReportPart = std::function<void(const std::string& part)>;

/// Writes the report of data already read; with a chapter on changes if it is compared with another store.
ReportSummary write_report(const ReportData& data, const std::string& out_directory,
                           const std::string& bundle_directory,
                           const std::optional<ReportBeside>& beside = {}, const OnReportPart& on_part = {});

}  // namespace edgewise::reports
