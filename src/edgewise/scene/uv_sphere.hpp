// SPDX-License-Identifier: MIT
//
// A sphere of meridians and parallels with 386 vertices: two poles and 24 parallels of 16 points. Given ring
// by ring, neighbours across rings are 16 vertices apart in memory, and the poles have 16 neighbours each;
// the spheres of sphere_points.hpp are given slice by slice, with few neighbours everywhere.
#pragma once

#include <vector>

#include "edgewise/geometry/vec.hpp"

namespace edgewise::scene {

/// On the same grid of coordinates as the other spheres, radii moved a little so that no quad is flat.
[[nodiscard]] std::vector<Vec3d> uv_sphere_points();

}  // namespace edgewise::scene
