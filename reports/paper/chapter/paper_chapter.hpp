// SPDX-License-Identifier: MIT
//
// The chapter on the paper's figures: the claims and how they fare, then part by part what the paper shows.
// A user's own scenes come before it.
#pragma once

#include <vector>

#include "edgewise/reports/page/chapters/chapters.hpp"

namespace edgewise::reports {

/// Own scenes, where there are any; then the paper, in two lines where none of its scenes was measured.
/// `charts`: those that the report has.
[[nodiscard]] std::vector<Chapter> paper_chapters(const ReportData& data, const std::vector<Chart>& charts);

}  // namespace edgewise::reports
