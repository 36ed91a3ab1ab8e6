// SPDX-License-Identifier: MIT
//
// Points, segments and polygons: which vertices stay, that faces come in pairs, and that the one rule of what
// is flat is the one that solids are refused by.
#include <gtest/gtest.h>

#include <algorithm>

#include "edgewise/geometry/hull.hpp"
#include "geometry_bodies.hpp"

namespace edgewise {
namespace {

using testing::Dice;
using testing::Points;
using testing::random_rotation;

Polyhedron made(const Points& points) {
    const auto body = flat_hull(points);
    EXPECT_TRUE(body) << body.error;
    return *body;
}

TEST(FlatHull, EqualPointsAreOnePoint) {
    const Polyhedron body = made({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
    EXPECT_EQ(body.input_index, std::vector<Index>{0});
    EXPECT_EQ(body.edge_count(), 0U);
    EXPECT_EQ(body.face_count(), 0U);
    EXPECT_TRUE(body.ring_of_vertex(0).empty());
}

TEST(FlatHull, PointsOnALineAreASegmentOfItsEnds) {
    const Polyhedron body = made({{1, 1, 1}, {3, 3, 3}, {0, 0, 0}, {2, 2, 2}, {3, 3, 3}});
    EXPECT_EQ(body.input_index, (std::vector<Index>{1, 2}));
    ASSERT_EQ(body.edge_count(), 1U);
    EXPECT_EQ(body.edges[0].left, no_face);
    EXPECT_EQ(body.edges[0].right, no_face);
    EXPECT_EQ(body.head(body.ring_of_vertex(0)[0]), 1U);
    EXPECT_EQ(body.head(body.ring_of_vertex(1)[0]), 0U);
}

TEST(FlatHull, APolygonHasAFrontAndABack) {
    const Polyhedron body =
        made({{0, 0, 5}, {2, 0, 5}, {1, 0, 5}, {2, 2, 5}, {1, 1, 5}, {0, 2, 5}, {0, 0, 5}});
    EXPECT_EQ(body.input_index, (std::vector<Index>{0, 1, 3, 5}));
    EXPECT_TRUE(check_polyhedron(body).empty()) << check_polyhedron(body).front();
    ASSERT_EQ(body.face_count(), 2U);
    EXPECT_EQ(body.face_planes[0].normal, Vec3d(-body.face_planes[1].normal));
    EXPECT_EQ(body.face_planes[0].offset, -body.face_planes[1].offset);
    EXPECT_EQ(std::abs(body.face_planes[0].normal.z()), 1.0);
}

/// Every point of the input lies within rounding of the polygon; every corner is one of them.
TEST(FlatHull, RandomPolygonsHoldTheirPoints) {
    Dice dice(5);
    std::size_t corners = 0;
    for (int i = 0; i < 300; ++i) {
        const Mat3d turn = random_rotation(dice);
        const Vec3d offset = 10 * dice.vector();
        const double thin = i % 3 == 0 ? 1e-6 : 1;
        Points points;
        for (std::size_t n = 3 + dice.below(40); n > 0; --n) {
            const Vec3d flat(dice.between(-1, 1), thin * dice.between(-1, 1), 0);
            points.push_back(turn * flat + offset);
        }
        const Polyhedron body = made(points);
        ASSERT_EQ(body.face_count(), 2U);
        corners += body.vertex_count();
        for (const HalfEdge h : body.ring_of_face(0)) {
            const Vec3d& tail = body.vertices[body.tail(h)];
            const Vec3d along = body.vertices[body.head(h)] - tail;
            const Vec3d into = cross(body.face_planes[0].normal, Vec3d(along / norm(along)));
            for (const Vec3d& p : points) EXPECT_GE(dot(into, Vec3d(p - tail)), -1e-13);
        }
    }
    EXPECT_GT(corners, 1500U);
}

TEST(FlatHull, OneRuleSaysWhatIsFlat) {
    Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1e-13}};
    EXPECT_EQ(hull_of_any(points)->face_count(), 2U);
    EXPECT_FALSE(convex_hull(points));
    points.back().z() = 1e-11;
    EXPECT_EQ(hull_of_any(points)->face_count(), 4U);
    EXPECT_TRUE(convex_hull(points));
}

TEST(FlatHull, BadPointsAreRefusedAsByTheHull) {
    EXPECT_FALSE(hull_of_any(Points{}));
    EXPECT_FALSE(flat_hull(Points{}));
    const Points bad = {{0, 0, 0}, {std::nan(""), 0, 0}};
    EXPECT_EQ(hull_of_any(bad).error, convex_hull(bad).error);
    EXPECT_EQ(flat_hull(bad).error, convex_hull(bad).error);
}

}  // namespace
}  // namespace edgewise
