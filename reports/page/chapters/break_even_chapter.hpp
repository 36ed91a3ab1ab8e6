// SPDX-License-Identifier: MIT
//
// The chapter on the winner at each place: the map, where the winner changes, and every place as a table.
#pragma once

#include <string>

#include "edgewise/reports/page/chapters/chapters.hpp"

namespace edgewise::reports {

[[nodiscard]] Chapter break_even_chapter(const Answer& answer, const ReportData& data);

/// Returns the parts that depend on the error limit, as JSON: {"1e-6": html}, for the limits that the
/// question bar offers.
[[nodiscard]] std::string break_even_data(const ReportData& data);

}  // namespace edgewise::reports
