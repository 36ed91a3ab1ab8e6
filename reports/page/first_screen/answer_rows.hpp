// SPDX-License-Identifier: MIT
//
// The answer's table: a row for each scene, with a strip of all table types in it.
#pragma once

#include <string>

#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// The most scenes in full view; the page's list of cells has them all.
inline constexpr std::size_t most_answer_rows = 12;

[[nodiscard]] std::string answer_rows_html(const Answer& answer);

/// Returns the answer's table as a grid without strips.
[[nodiscard]] TextGrid answer_grid(const Answer& answer);

}  // namespace edgewise::reports
