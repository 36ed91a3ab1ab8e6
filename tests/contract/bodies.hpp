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

/// Hull of the points; may be flat.
[[nodiscard]] inline Polyhedron hull(const std::vector<Vec3d>& points) {
    const auto body = hull_of_any(points);
    EXPECT_TRUE(body) << body.error;
    return *body;
}

/// A hull without symmetry, far from its own origin, with faces of every size.
[[nodiscard]] inline Polyhedron random_hull(std::uint64_t seed) {
    scene::Rng rng(seed);
    std::vector<Vec3d> points;
    for (int i = 0; i < 60; ++i)
        points.push_back(rng.in_ball().cwiseProduct(Vec3d(1, 0.6, 0.3)) + Vec3d(2, -1, 0.5));
    return hull(points);
}

[[nodiscard]] inline std::vector<NamedBody> flat_bodies() {
    return {{"point", hull({{0.25, -0.5, 0.125}})},
            {"segment", hull({{-0.5, 0.25, 0}, {0.75, -0.25, 0.5}})},
            {"triangle", hull({{-0.5, 0, 0.25}, {0.75, 0, -0.25}, {0, 1, 0.5}})},
            {"square", hull({{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}})}};
}

/// A flat body with two faces, front and back.
[[nodiscard]] inline Polyhedron polygon() {
    const Polyhedron body = hull({{1, 0, 0.5}, {0, 1, 0.25}, {-1, 0, -0.5}, {-0.5, -1, -0.5}, {0.5, -1, 0}});
    EXPECT_EQ(body.face_count(), 2U);
    return body;
}

/// A box about the origin with sides along the axes.
[[nodiscard]] inline Polyhedron centred_box(const Vec3d& half) {
    std::vector<Vec3d> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(i & 1 ? half[0] : -half[0], i & 2 ? half[1] : -half[1],
                            i & 4 ? half[2] : -half[2]);
    return hull(points);
}

/// For layouts that hold nothing but boxes.
[[nodiscard]] inline std::vector<NamedBody> boxes() {
    return {{"box8", shape("box8")},
            {"square tile", centred_box({1, 0.25, 1})},
            {"beam", centred_box({0.5, 2, 0.125})},
            {"plate", centred_box({1, 0.75, 0.125})}};
}

[[nodiscard]] inline std::vector<NamedBody> given_bodies() {
    return {{"tetra4", shape("tetra4")},     {"cube8", shape("cube8")},
            {"sphere38", shape("sphere38")}, {"sphere386", shape("sphere386")},
            {"random hull", random_hull(5)}, {"polygon", polygon()}};
}

}  // namespace edgewise
