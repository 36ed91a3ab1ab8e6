// SPDX-License-Identifier: MIT
//
// Poses of two bodies at random, in the regimes that matter: free ones, and groups of poses that share their
// orientation, or nearly, at gaps from three sizes to 2^-36 of one and depths likewise; two in ten groups
// nearly parallel, one parallel, one on a lattice.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise::studies::campaign {

/// The first `count` poses of a block with this seed.
[[nodiscard]] std::vector<std::pair<Pose, Pose>> random_poses(const Polyhedron& a, const Polyhedron& b,
                                                              std::uint64_t seed, std::uint64_t count);

}  // namespace edgewise::studies::campaign
