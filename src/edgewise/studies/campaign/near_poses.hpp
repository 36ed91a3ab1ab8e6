// SPDX-License-Identifier: MIT
//
// Poses near those that a hard family made: hard cases come in neighbourhoods, and the next one may be a
// rounding step away from the known case.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise::studies::campaign {

/// Returns `made`, then poses near each of them in turn, up to `count`.
[[nodiscard]] std::vector<std::pair<Pose, Pose>> near_poses(const Polyhedron& a, const Polyhedron& b,
                                                            const std::vector<std::pair<Pose, Pose>>& made,
                                                            std::uint64_t seed, std::uint64_t count);

}  // namespace edgewise::studies::campaign
