// SPDX-License-Identifier: MIT
//
// Points, segments and polygons: which vertices stay, that faces come in pairs, and that the one rule of what
// is flat is the one that solids are refused by.
//
// Boxes are strictly convex; a body with a face cut in two is not, and one with a face folded outward by more
// than the rule's angle is again.
#include <gtest/gtest.h>

#include <algorithm>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/strictly_convex.hpp"
#include "folded_pyramid.hpp"
#include "geometry_bodies.hpp"

namespace edgewise {
namespace {

using testing::Dice;
using testing::folded_pyramid;
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

constexpr double least = 1e-4;

TEST(StrictlyConvex, BoxesAreHoweverTheyLie) {
    Dice dice(3);
    for (int i = 0; i < 200; ++i) {
        const Mat3d turn = random_rotation(dice);
        const Vec3d size(dice.between(0.01, 1), 1, dice.between(1, 100));
        Points points;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3d signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            points.push_back(turn * Vec3d(signs.cwiseProduct(size)));
        }
        EXPECT_TRUE(is_strictly_convex(*convex_hull(points), least));
    }
}

TEST(StrictlyConvex, ASharpNeedleIsUntilItsEndIsLostInRounding) {
    const auto needle = [](double length) {
        return *convex_hull(Points{{0, 0, 0}, {length, 0.5, 0.5}, {0, 1, 0}, {0, 0, 1}});
    };
    EXPECT_TRUE(is_strictly_convex(needle(1e3), least));
    EXPECT_FALSE(is_strictly_convex(needle(1e8), least));
}

TEST(StrictlyConvex, ACornerCutOffIsUntilItIsTiny) {
    const auto cut = [](double size) {
        Points points;
        for (int corner = 1; corner < 8; ++corner)
            points.emplace_back(corner & 1, corner >> 1 & 1, corner >> 2);
        for (int i = 0; i < 3; ++i) points.push_back(size * Vec3d(Mat3d::Identity().col(i)));
        return *convex_hull(points);
    };
    EXPECT_TRUE(is_strictly_convex(cut(1e-2), least));
    EXPECT_FALSE(is_strictly_convex(cut(1e-6), least));
}

/// A hull may take four corners for one face though one is off by some dozen rounding steps.
TEST(StrictlyConvex, ABentFaceIsNotBeyondRounding) {
    const auto bent = [](double by) {
        return *convex_hull(Points{{-1, -0.5, -1},
                                   {1, -0.5, -1},
                                   {-1, 0.5, -1},
                                   {1, 0.5, -1},
                                   {-1, -0.5, 1},
                                   {1, -0.5, 3.230571746826172e-05},
                                   {-1, 0.5, 1},
                                   {1 + by, 0.5, 1}});
    };
    const double merged = 64 * 0x1p-52;
    EXPECT_EQ(bent(merged).face_count(), bent(0).face_count());
    EXPECT_TRUE(is_strictly_convex(bent(0), least));
    EXPECT_TRUE(is_strictly_convex(bent(0x1p-52), least));
    EXPECT_FALSE(is_strictly_convex(bent(merged), least));
}

TEST(StrictlyConvex, ACutFaceIsNotUntilItIsFolded) {
    EXPECT_FALSE(is_strictly_convex(folded_pyramid(0), least));
    EXPECT_FALSE(is_strictly_convex(folded_pyramid(1e-5), least));
    EXPECT_TRUE(is_strictly_convex(folded_pyramid(1e-3), least));
}

/// Climbs ask for less: a fold of some rounding steps will do, but neither a flat face cut in two nor one
/// that is folded inwards.
TEST(StrictlyConvex, ACutFaceIsClimbableOnceItIsFoldedOutwards) {
    EXPECT_FALSE(is_climbable(folded_pyramid(0)));
    EXPECT_TRUE(is_climbable(folded_pyramid(1e-12)));
    EXPECT_TRUE(is_climbable(folded_pyramid(1e-5)));
    EXPECT_FALSE(is_climbable(folded_pyramid(-1e-13)));
}

/// Solids below thin_solid are not believed without a proof; polygons, which are flat, and thicker solids
/// are.
TEST(StrictlyConvex, ThinSolidsAreNot) {
    constexpr double strict = Tolerance<double>::strict_turn;
    for (const double thick : {0x1p-40, 0x1p-30, 0x1p-20, 0x1p-17, 0x1p-14, 0x1p-8, 1.0}) {
        const std::vector<Vec3d> corners = {
            {1, 0, 0}, {-1, 0, 0}, {0, 1, thick}, {0, -1, thick}, {0, 0, -thick}};
        EXPECT_EQ(is_strictly_convex(*convex_hull(corners), strict), thick >= 0x1p-14) << thick;
    }
    const std::vector<Vec3d> polygon = {{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
    EXPECT_TRUE(is_strictly_convex(*hull_of_any(polygon), strict));
}

}  // namespace
}  // namespace edgewise
