// SPDX-License-Identifier: MIT
//
// What names a cell in files of results: one list of columns for all of them.
#pragma once

#include <nlohmann/json.hpp>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/results/csv_row.hpp"

namespace edgewise::reports {

/// Adds the names of the columns.
void add_identity_header(CsvRow& row);
/// Adds their values.
void add_identity(CsvRow& row, const ReportData& data, const ReportCell& cell);
/// The same as members of an object, in the same order.
[[nodiscard]] nlohmann::ordered_json identity_json(const ReportData& data, const ReportCell& cell);

}  // namespace edgewise::reports
