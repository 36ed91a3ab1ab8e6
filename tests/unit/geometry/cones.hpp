// SPDX-License-Identifier: MIT
//
// One tip or two over a regular polygon: vertices with any number of neighbours.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "edgewise/geometry/hull.hpp"

namespace edgewise::testing {

/// Tips come first, then the corners of a polygon of radius 1 in the plane of x and y.
inline Polyhedron cone(std::vector<Vec3d> tips, int sides) {
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        tips.push_back({std::cos(angle), std::sin(angle), 0});
    }
    return convex_hull(tips).or_throw();
}

/// A fan under a tip.
inline Polyhedron pyramid(int sides) { return cone({{0, 0, 1}}, sides); }

/// Two tips over and under the polygon.
inline Polyhedron double_cone(int sides) { return cone({{0, 0, 1}, {0.1, 0, -1}}, sides); }

}  // namespace edgewise::testing
