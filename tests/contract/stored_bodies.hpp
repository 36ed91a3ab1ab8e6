// SPDX-License-Identifier: MIT
//
// The bodies that tables are tested on, as the table under test stores them: rounded to single, where it
// does.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"
#include "table_under_test.hpp"

namespace edgewise {

using Table = TableUnderTest::Table;
using Stored = Table::PrecisionType::Stored;
using Compute = ComputeOf<Table>;
using TableTypes = ::testing::Types<TableUnderTest>;

/// Planes computed when asked for, from corners.
template <class T>
concept DerivesPlanes = requires {
    T::derives_planes;
};

inline constexpr bool has_features = FeatureTable<Table>;
inline constexpr double compute_eps = std::numeric_limits<Compute>::epsilon();
/// What planes are rounded to.
inline constexpr double stored_eps =
    DerivesPlanes<Table> ? compute_eps : double{std::numeric_limits<Stored>::epsilon()};

struct NamedBody {
    std::string name;
    Polyhedron body;
};

/// What a table holds when it is given this body.
[[nodiscard]] inline Polyhedron as_stored(const Polyhedron& body) {
    auto stored = stored_body<Table>(body);
    EXPECT_TRUE(stored) << stored.error;
    return *stored;
}

[[nodiscard]] inline Polyhedron shape(const std::string& name) {
    const auto body = scene::make_shape(name);
    EXPECT_TRUE(body) << body.error;
    return as_stored(*body);
}

/// A lopsided hull far off its own origin: no symmetry, faces of every size.
[[nodiscard]] inline Polyhedron random_hull(std::uint64_t seed) {
    scene::Rng rng(seed);
    std::vector<Vec3d> points;
    for (int i = 0; i < 60; ++i)
        points.push_back(rng.in_ball().cwiseProduct(Vec3d(1, 0.6, 0.3)) + Vec3d(2, -1, 0.5));
    const auto hull = convex_hull(points);
    EXPECT_TRUE(hull) << hull.error;
    return as_stored(*hull);
}

/// Flat: a front, a back, and no third face at any corner.
[[nodiscard]] inline Polyhedron polygon() {
    const std::vector<Vec3d> corners = {
        {1, 0, 0.5}, {0, 1, 0.25}, {-1, 0, -0.5}, {-0.5, -1, -0.5}, {0.5, -1, 0}};
    const auto hull = hull_of_any(corners);
    EXPECT_TRUE(hull) << hull.error;
    EXPECT_EQ(hull->face_count(), 2U);
    return as_stored(*hull);
}

[[nodiscard]] inline const std::vector<NamedBody>& test_bodies() {
    static const std::vector<NamedBody> bodies = {
        {"tetra4", shape("tetra4")},       {"cube8", shape("cube8")},       {"sphere38", shape("sphere38")},
        {"sphere386", shape("sphere386")}, {"random hull", random_hull(5)}, {"polygon", polygon()}};
    return bodies;
}

/// The face of the body that a table's face is: handles are the table's own, its rings are the body's.
template <class T>
[[nodiscard]] Index body_face(const T& table, const typename T::Face& f, const Polyhedron& body) {
    const auto [edge, flipped] = *table.ring_of_face(f).begin();
    const Index from = table.index_of(flipped ? table.head(edge) : table.tail(edge));
    const Index to = table.index_of(flipped ? table.tail(edge) : table.head(edge));
    for (const HalfEdge h : body.ring_of_vertex(from)) {
        if (body.head(h) == to) return body.face(h);
    }
    return no_face;
}

}  // namespace edgewise
