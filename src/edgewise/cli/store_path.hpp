// SPDX-License-Identifier: MIT
//
// Where a sweep leaves its store and its report when nobody says otherwise: reports/out below the current
// folder.
#pragma once

namespace edgewise::cli {

inline constexpr const char* default_store = "reports/out/edgewise.db";
inline constexpr const char* default_report = "reports/out";

}  // namespace edgewise::cli
