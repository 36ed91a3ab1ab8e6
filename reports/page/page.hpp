// SPDX-License-Identifier: MIT
//
// The report as one self-contained HTML file, complete in its statements without scripts, alive with them, no
// network either way; and as Markdown of a length that a person pastes somewhere.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/page/pictures.hpp"

namespace edgewise::reports {

/// `bundles`: what bundle_elements gives, or empty when they were not available.
[[nodiscard]] std::string page_html(const ReportData& data, const Answer& answer,
                                    const std::vector<Chapter>& chapters, const std::vector<Chart>& charts,
                                    const StaticPictures& pictures, const std::string& bundles);

/// `changes`: what chapter_markdown makes of its chapter, or empty where nothing is compared.
[[nodiscard]] std::string report_markdown(const ReportData& data, const Answer& answer,
                                          const StaticPictures& pictures, const std::string& changes = {});
/// Returns a chapter with the first rows of its tables.
[[nodiscard]] std::string chapter_markdown(const Chapter& chapter);

}  // namespace edgewise::reports
