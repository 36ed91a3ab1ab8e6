// SPDX-License-Identifier: MIT
//
// One row of the answer as a picture: every ranked cell's time over the baseline's on a logarithmic axis, the
// band of noise, and the interval of the choice.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/ranking.hpp"

namespace edgewise::reports {

/// The axis that all strips of a table share.
struct StripAxis {
    double low = 0.5, high = 8;
};
/// Wide enough for every ranked cell, within a quarter and sixteen times.
[[nodiscard]] StripAxis strip_axis(const std::vector<const SceneRanking*>& scenes);

[[nodiscard]] std::string strip_svg(const SceneRanking& scene, const StripAxis& axis);
/// The axis's numbers, for the table's head.
[[nodiscard]] std::string strip_head_svg(const StripAxis& axis);

}  // namespace edgewise::reports
