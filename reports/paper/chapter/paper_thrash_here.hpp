// SPDX-License-Identifier: MIT
//
// The thrash on the machine that measured: what its own caches make of figures 7 and 8, in times.
#pragma once

#include <string>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// V-Clip's time at 386 vertices over that at 38, at the fastest rotation, with a table for every body and
/// with one for all; GJK's beside it. What is not stored is said to be missing.
[[nodiscard]] std::string thrash_here(const ReportData& data);

}  // namespace edgewise::reports
