// SPDX-License-Identifier: MIT
//
// Time against bytes: one point per algorithm and table type of a scene, and the Pareto front of those within
// the error, named at its points.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/ranking.hpp"

namespace edgewise::reports {

/// Indices of cells that no other within the error beats in both, fewest bytes first.
[[nodiscard]] std::vector<std::size_t> front_of_time_and_bytes(const SceneRanking& scene);

/// A picture of the page as a file of its own, black on white.
[[nodiscard]] std::string standalone(const std::string& svg);

[[nodiscard]] std::string time_bytes_svg(const SceneRanking& scene);

}  // namespace edgewise::reports
