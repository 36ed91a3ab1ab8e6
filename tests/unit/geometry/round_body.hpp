// SPDX-License-Identifier: MIT
//
// A body of any number of vertices: seeded points on a sphere, all of them corners, 3 V - 6 edges.
#pragma once

#include <cstddef>
#include <vector>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::testing {

inline Polyhedron round_body(std::size_t vertices) {
    scene::Rng rng(vertices);
    std::vector<Vec3d> points;
    while (points.size() < vertices) points.push_back(rng.on_sphere());
    return *convex_hull(points);
}

}  // namespace edgewise::testing
