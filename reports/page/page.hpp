// SPDX-License-Identifier: MIT
//
// The report as one self-contained HTML file, readable without scripts, alive with them, no network either
// way; its tables as Markdown, for a repository or a terminal.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/page/pictures.hpp"

namespace edgewise::reports {

/// "246 cells verified, 3 failed, 1 unavailable."
[[nodiscard]] std::string verdict_line(const ReportData& data);

/// `scripts`: the bundles as script elements, or empty when they were not available.
[[nodiscard]] std::string page_html(const ReportData& data, const std::vector<Chart>& charts,
                                    const StaticPictures& pictures, const std::string& scripts);

[[nodiscard]] std::string report_markdown(const ReportData& data, const std::vector<Chart>& charts,
                                          const StaticPictures& pictures);

}  // namespace edgewise::reports
