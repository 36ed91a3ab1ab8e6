// SPDX-License-Identifier: MIT
//
// The chapter on the paper's figures: the claims and how they fare, then part by part what the paper shows.
#pragma once

#include <optional>
#include <vector>

#include "edgewise/reports/page/chapters.hpp"

namespace edgewise::reports {

/// Null when the store holds no scenes from files. `charts`: those that the report has.
[[nodiscard]] std::optional<Chapter> paper_chapter(const ReportData& data, const std::vector<Chart>& charts);

}  // namespace edgewise::reports
