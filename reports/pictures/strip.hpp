// SPDX-License-Identifier: MIT
//
// One row of the answer as a picture: every table type's time over the baseline's on a logarithmic axis, the
// band of noise, and the interval of the choice.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/scene_answer.hpp"

namespace edgewise::reports {

/// The axis that all strips of a table share.
struct StripAxis {
    double low = 0.5, high = 8;
};
/// Wide enough for every candidate, within a quarter and sixteen times.
[[nodiscard]] StripAxis strip_axis(const std::vector<const SceneAnswer*>& scenes);

[[nodiscard]] std::string strip_svg(const SceneAnswer& scene, const StripAxis& axis);
/// The axis's numbers, for the table's head.
[[nodiscard]] std::string strip_head_svg(const StripAxis& axis);

}  // namespace edgewise::reports
