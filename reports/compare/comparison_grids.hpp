// SPDX-License-Identifier: MIT
//
// A comparison of two stores as tables, regressions first, and in one sentence.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/compare/comparison.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// How much became worse, how much better, of how many; times within `slack` are none of these.
[[nodiscard]] std::string comparison_sentence(const Comparison& comparison, double slack);

/// Worse exactly, slower, better exactly, faster, in this order; none without rows. What a change of time is
/// made of stands beside it.
[[nodiscard]] std::vector<TextGrid> change_grids(const Comparison& comparison, double slack);

/// What the two runs have in common, which is excluded as a cause, and what not.
[[nodiscard]] TextGrid conditions_grid(const Comparison& comparison);

}  // namespace edgewise::reports
