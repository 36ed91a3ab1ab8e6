// SPDX-License-Identifier: MIT
//
// The report as one self-contained HTML file: readable without scripts, alive with them, no network either
// way.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/page/figures.hpp"
#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// "246 cells verified, 3 failed, 1 unavailable."
[[nodiscard]] std::string verdict_line(const ReportData& data);
/// The two sentences at the top of every page.
[[nodiscard]] std::string report_purpose();
/// What the bytes table's columns mean.
[[nodiscard]] std::string bytes_explanation();
[[nodiscard]] std::string layout_explanation();
[[nodiscard]] std::string cache_explanation(const ReportData& data);
[[nodiscard]] std::string counter_explanation(const ReportData& data);
[[nodiscard]] std::string time_explanation();
[[nodiscard]] std::string error_explanation();
[[nodiscard]] std::string stability_explanation(const ReportData& data);

/// `scripts`: the bundles as script elements, or empty when they were not available.
[[nodiscard]] std::string page_html(const ReportData& data, const std::vector<Chart>& charts,
                                    const StaticFigures& figures, const std::string& scripts);

}  // namespace edgewise::reports
