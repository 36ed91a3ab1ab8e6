// SPDX-License-Identifier: MIT
//
// What happens in a scene, in one sentence: its bodies, how they move, and whether they share a table.
#pragma once

#include <string>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// Of a scene file its kind of scene, else the scene itself.
[[nodiscard]] std::string scene_kind(const ReportCell& cell);

/// Whether every body has a table of its own; else they share one.
[[nodiscard]] bool has_own_tables(const ReportCell& cell);

/// "100 bodies drift and turn by 0.1 rad per step, followed from step to step; one shared table".
[[nodiscard]] std::string scene_sentence(const ReportCell& cell);

}  // namespace edgewise::reports
