// SPDX-License-Identifier: MIT
//
// What the exact arithmetic cannot take: an empty body, NaN, infinity.
#pragma once

#include <span>
#include <string>

#include "edgewise/geometry/pose.hpp"

namespace edgewise::truth {

/// One line that says what is wrong with a pair of bodies; empty if nothing is.
[[nodiscard]] std::string pair_error(std::span<const Vec3d> a, const Pose& pose_a, std::span<const Vec3d> b,
                                     const Pose& pose_b);

}  // namespace edgewise::truth
