// SPDX-License-Identifier: MIT
//
// Random poses of two bodies in the regimes that matter: free poses, and groups of poses that share their
// orientation, or nearly. Gaps and depths range from three sizes to 2^-36 of one. Of ten groups, two are
// nearly parallel, one is parallel, one is on a lattice.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise::studies::campaign {

/// Returns the first `count` poses of a block with this seed.
[[nodiscard]] std::vector<std::pair<Pose, Pose>> random_poses(const Polyhedron& a, const Polyhedron& b,
                                                              std::uint64_t seed, std::uint64_t count);

}  // namespace edgewise::studies::campaign
