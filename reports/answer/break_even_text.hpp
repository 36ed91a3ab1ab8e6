// SPDX-License-Identifier: MIT
//
// The break-even map in words: how many places each layout wins, where the winner changes from one body to a
// larger one, and every place as a table.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/break_even_map.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// How many places were measured, how many one algorithm and layout wins, and which of them how often; empty
/// where nothing was measured.
[[nodiscard]] std::string break_even_sentence(const BreakEvenMap& map);

/// A line for each row of the map with two sizes of bodies or more: from how many vertices on who wins.
[[nodiscard]] std::vector<std::string> break_even_lines(const BreakEvenMap& map);

/// The tie set of the place's scene and what is beside it; or why there is nothing.
[[nodiscard]] std::string cell_text(const MapCell& cell);

/// A row per coherence and number of tables, a column per body, at most `most_columns` of those of which the
/// most was measured; what is not measured with its reason.
[[nodiscard]] TextGrid break_even_grid(const BreakEvenMap& map, std::size_t most_columns = most_map_columns);

}  // namespace edgewise::reports
