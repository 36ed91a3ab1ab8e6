// SPDX-License-Identifier: MIT
//
// The bodies that tables are tested on, before any table rounds them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise {

struct NamedBody {
    std::string name;
    Polyhedron body;
};

[[nodiscard]] inline Polyhedron shape(const std::string& name) {
    const auto body = scene::make_shape(name);
    EXPECT_TRUE(body) << body.error;
    return *body;
}

/// A lopsided hull far off its own origin: no symmetry, faces of every size.
[[nodiscard]] inline Polyhedron random_hull(std::uint64_t seed) {
    scene::Rng rng(seed);
    std::vector<Vec3d> points;
    for (int i = 0; i < 60; ++i)
        points.push_back(rng.in_ball().cwiseProduct(Vec3d(1, 0.6, 0.3)) + Vec3d(2, -1, 0.5));
    const auto hull = convex_hull(points);
    EXPECT_TRUE(hull) << hull.error;
    return *hull;
}

/// Flat: a front, a back, and no third face at any corner.
[[nodiscard]] inline Polyhedron polygon() {
    const std::vector<Vec3d> corners = {
        {1, 0, 0.5}, {0, 1, 0.25}, {-1, 0, -0.5}, {-0.5, -1, -0.5}, {0.5, -1, 0}};
    const auto hull = hull_of_any(corners);
    EXPECT_TRUE(hull) << hull.error;
    EXPECT_EQ(hull->face_count(), 2U);
    return *hull;
}

[[nodiscard]] inline std::vector<NamedBody> given_bodies() {
    return {{"tetra4", shape("tetra4")},     {"cube8", shape("cube8")},
            {"sphere38", shape("sphere38")}, {"sphere386", shape("sphere386")},
            {"random hull", random_hull(5)}, {"polygon", polygon()}};
}

}  // namespace edgewise
