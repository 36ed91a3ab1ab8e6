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

/// Says how many places were measured, how many have a single winner, and how often each layout wins; empty
/// if nothing was measured.
[[nodiscard]] std::string break_even_sentence(const BreakEvenMap& map);

/// Returns a line for each row of the map with two or more sizes of bodies: which cell wins at which sizes.
[[nodiscard]] std::vector<std::string> break_even_lines(const BreakEvenMap& map);

/// Returns the tie set of the place's scene with notes, or the reason why there is no result.
[[nodiscard]] std::string cell_text(const MapCell& cell);

/// Returns a row per coherence and number of tables and a column per body, at most `most_columns`, the ones
/// with most measured cells; places that were not measured have a reason.
[[nodiscard]] TextGrid break_even_grid(const BreakEvenMap& map, std::size_t most_columns = most_map_columns);

}  // namespace edgewise::reports
