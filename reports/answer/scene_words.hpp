// SPDX-License-Identifier: MIT
//
// What happens in a scene, in one sentence: its bodies, how they move, and whether they share a table.
#pragma once

#include <string>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// Returns the kind of scene of a scene file, else the scene itself.
[[nodiscard]] std::string scene_kind(const ReportCell& cell);

/// Returns true if every body has a table of its own, false if all share one.
[[nodiscard]] bool has_own_tables(const ReportCell& cell);

/// Returns "100 bodies drift and turn by 0.1 rad per step, followed from step to step; one shared table".
[[nodiscard]] std::string scene_sentence(const ReportCell& cell);

}  // namespace edgewise::reports
