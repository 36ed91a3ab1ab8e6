// SPDX-License-Identifier: MIT
//
// Every figure of every cell as comma-separated values (RFC 4180): one row per cell and figure. A figure
// without a value has an empty value field, the state "not measured" and its reason; a cell without figures
// still has one row.
#pragma once

#include <string>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

[[nodiscard]] std::string results_csv(const ReportData& data);

}  // namespace edgewise::reports
