// SPDX-License-Identifier: MIT
//
// Boxes are strictly convex; a body with a face cut in two is not, and one with a face folded outward by more
// than the rule's angle is again.
#include <gtest/gtest.h>

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
    constexpr double least = Tolerance<double>::strict_turn;
    for (const double thick : {0x1p-40, 0x1p-30, 0x1p-20, 0x1p-17, 0x1p-14, 0x1p-8, 1.0}) {
        const std::vector<Vec3d> corners = {
            {1, 0, 0}, {-1, 0, 0}, {0, 1, thick}, {0, -1, thick}, {0, 0, -thick}};
        EXPECT_EQ(is_strictly_convex(*convex_hull(corners), least), thick >= 0x1p-14) << thick;
    }
    const std::vector<Vec3d> polygon = {{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}};
    EXPECT_TRUE(is_strictly_convex(*hull_of_any(polygon), least));
}

}  // namespace
}  // namespace edgewise
