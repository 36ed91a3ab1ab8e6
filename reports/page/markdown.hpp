// SPDX-License-Identifier: MIT
//
// The report as Markdown: the page's tables, for a repository or a terminal.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/page/pictures.hpp"
#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

[[nodiscard]] std::string report_markdown(const ReportData& data, const std::vector<Chart>& charts,
                                          const StaticPictures& pictures);

}  // namespace edgewise::reports
