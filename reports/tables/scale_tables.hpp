// SPDX-License-Identifier: MIT
//
// One table at many scales beside a table for each: what sharing saves in bytes and costs in time.
#pragma once

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// Cells that measured it (probe scale), by scene and shape.
[[nodiscard]] TextGrid scale_grid(const ReportData& data);

}  // namespace edgewise::reports
