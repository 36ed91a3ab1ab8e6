// SPDX-License-Identifier: MIT
//
// A second opinion on distances, with nothing in common with GJK or V-Clip: every face normal and edge pair
// as a separating axis, then every vertex against every face and every edge against every edge. Plain double,
// slow, and good to rounding only. The nearest points of two separated bodies are on a vertex and a face or
// on two edges (ends included), so the least over both kinds is the distance.
#pragma once

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise::truth {

/// Distance between two solid bodies; 0 when no axis separates them.
[[nodiscard]] double brute_force_distance(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b,
                                          const Pose& pose_b);

}  // namespace edgewise::truth
