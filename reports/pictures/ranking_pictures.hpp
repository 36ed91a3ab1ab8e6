// SPDX-License-Identifier: MIT
//
// Pictures of ranked cells, drawn by hand.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/break_even_map.hpp"
#include "edgewise/reports/answer/ranking.hpp"

namespace edgewise::reports {

/// "V-Clip on aos_f64: 1.05 [1.01, 1.15], error 2.2e-16, 234 bytes per edge"
[[nodiscard]] std::string mark_text(const RankedCell& cell);

/// The axis that all strips of a table share.
struct StripAxis {
    double low = 0.5, high = 8;
};
/// Wide enough for every ranked cell, within a quarter and sixteen times.
[[nodiscard]] StripAxis strip_axis(const std::vector<const SceneRanking*>& scenes);

[[nodiscard]] std::string strip_svg(const SceneRanking& scene, const StripAxis& axis);
/// The axis's numbers, for the table's head.
[[nodiscard]] std::string strip_head_svg(const StripAxis& axis);

/// Indices of cells that no other within the error beats in both, fewest bytes first.
[[nodiscard]] std::vector<std::size_t> front_of_time_and_bytes(const SceneRanking& scene);

/// A picture of the page as a file of its own, black on white.
[[nodiscard]] std::string standalone(const std::string& svg);

[[nodiscard]] std::string time_bytes_svg(const SceneRanking& scene);

// The break-even map as a picture: a grid for each number of tables, vertices across, coherence downwards. A
// place is tinted in the colour of the layout that wins; one where several tie has a bar of all their colours
// and no tint; one that was not measured is dashed and says so.

/// Empty where nothing was measured.
[[nodiscard]] std::string break_even_svg(const BreakEvenMap& map);

}  // namespace edgewise::reports
