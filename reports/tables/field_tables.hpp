// SPDX-License-Identifier: MIT
//
// Which fields of a table's records travel together, as the fields run stored it: what was advised, what it
// was predicted to save, and what became of that when a table was built so.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// One row per table and algorithm: lines before, predicted and counted, misses, times, verdicts.
[[nodiscard]] TextGrid field_advice_grid(const ReportData& data);
/// The advised records of one row, next to the records of the table.
[[nodiscard]] TextGrid field_groups_grid(const ReportCell& row);
/// Says in one sentence how often advice held in lines and in time, over all rows.
[[nodiscard]] std::string field_verdict(const ReportData& data);

/// The matrix of one row, as an SVG (charts/co_access_picture.hpp).
[[nodiscard]] std::string field_picture(const ReportCell& row);

}  // namespace edgewise::reports
