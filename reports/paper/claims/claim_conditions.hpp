// SPDX-License-Identifier: MIT
//
// Where a verdict holds. Counts hold wherever the same seeds are drawn; times hold on the machine that took
// them, and what its caches keep may decide them.
#pragma once

#include <string>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// "for seed 1, on any machine"; where times decide also the processor, its caches from the second level on,
/// and the compiler: "for seed 1, on this machine: Intel Xeon, L2 2 MiB, L3 480 MiB; c++ 12.2".
[[nodiscard]] std::string claim_conditions(const ReportData& data, bool deterministic);

}  // namespace edgewise::reports
