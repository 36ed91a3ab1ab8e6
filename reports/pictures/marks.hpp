// SPDX-License-Identifier: MIT
//
// Marks of ranked cells, the same in every picture drawn by hand: colour by layout, a circle for V-Clip, a
// triangle for GJK, a square for another library; filled within the error limit, hollow over it.
#pragma once

#include <string>

#include "edgewise/reports/answer/ranking.hpp"

namespace edgewise::reports {

/// With its name, ratio and error as a tooltip.
[[nodiscard]] std::string mark_svg(const RankedCell& cell, double x, double y, double size);

/// "V-Clip on aos_f64: 1.05 [1.01, 1.15], error 2.2e-16, 234 bytes per edge"
[[nodiscard]] std::string mark_text(const RankedCell& cell);

}  // namespace edgewise::reports
