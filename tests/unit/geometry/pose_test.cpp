// SPDX-License-Identifier: MIT
//
// Poses against exact cases and against each other: the relative pose maps as the two poses one after the
// other do.
#include "edgewise/geometry/pose.hpp"

#include <cmath>
#include <cstdio>

#include "edgewise/scene/rng.hpp"
#include "geometry_bodies.hpp"

namespace edgewise {
namespace {

using testing::Dice;
using testing::random_rotation;

Pose random_pose(Dice& dice, double reach) {
    Pose pose;
    pose.rotation = random_rotation(dice);
    pose.translation = dice.vector() * reach;
    return pose;
}

Transform<double> random_transform(Dice& dice) {
    const Pose a = random_pose(dice, 3);
    const Pose b = random_pose(dice, 3);
    return relative_pose(a, b);
}

TEST(Pose, QuarterTurnIsExact) {
    Pose pose;
    pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    pose.translation = Vec3d(10, 20, 30);
    EXPECT_EQ(pose.apply(Vec3d(1, 2, 3)), Vec3d(8, 21, 33));
    EXPECT_EQ(Pose().apply(Vec3d(1, 2, 3)), Vec3d(1, 2, 3));
    EXPECT_EQ(ortho_error(pose.rotation), 0);
}

TEST(Pose, RelativePoseTakesPointsOfBIntoTheFrameOfA) {
    Dice dice(41);
    double worst = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const Pose a = random_pose(dice, 3);
        const Pose b = random_pose(dice, 3);
        const Vec3d p = dice.vector();
        const Vec3d in_a = relative_pose(a, b).point(p);
        worst = std::max(worst, norm(Vec3d(a.apply(in_a) - b.apply(p))));
    }
    std::printf("worst difference in the world: %.2g\n", worst);
    EXPECT_LE(worst, 1e-14);
    EXPECT_GT(worst, 0);
}

TEST(Pose, FarOffOriginCostsNoDigits) {
    Dice dice(42);
    for (int trial = 0; trial < 100; ++trial) {
        Pose a = random_pose(dice, 0);
        Pose b = random_pose(dice, 0);
        b.translation = Vec3d(1.0 + trial, 0.5, -0.25);
        const Transform<double> near = relative_pose(a, b);
        const Vec3d far(0x1p40, -0x1p41, 0x1p39);
        a.translation += far;
        b.translation += far;  // exact: both fit in 53 bits
        const Transform<double> moved = relative_pose(a, b);
        EXPECT_EQ(near.translation, moved.translation);
        EXPECT_EQ(near.rotation, moved.rotation);
    }
}

TEST(Transform, InverseUndoesPointsAndDirections) {
    Dice dice(43);
    double worst = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const Transform<double> t = random_transform(dice);
        const Vec3d p = dice.vector();
        worst = std::max(worst, norm(Vec3d(t.inverse().point(t.point(p)) - p)));
        worst = std::max(worst, norm(Vec3d(t.direction_back(t.direction(p)) - p)));
        EXPECT_EQ(t.inverse().direction(p), t.direction_back(p));
    }
    std::printf("worst round trip: %.2g\n", worst);
    EXPECT_LE(worst, 1e-14);
}

TEST(OrthoError, IsTheLargestEntryOfTheDefect) {
    Mat3d stretched = Mat3d::Identity();
    stretched(1, 1) = 1.5;
    EXPECT_EQ(ortho_error(stretched), 1.25);
    Mat3d sheared = Mat3d::Identity();
    sheared(0, 2) = 0.25;
    EXPECT_EQ(ortho_error(sheared), 0.25);
    for (int entry = 0; entry < 9; ++entry) {
        Pose unknown;
        unknown.rotation(entry / 3, entry % 3) = NAN;
        EXPECT_TRUE(std::isnan(ortho_error(unknown.rotation))) << entry;
        EXPECT_FALSE(is_orthonormalised(unknown));
    }
    Dice dice(45);
    double worst = 0;
    for (int trial = 0; trial < 1000; ++trial) worst = std::max(worst, ortho_error(random_rotation(dice)));
    std::printf("worst ortho_error of a random rotation: %.2g\n", worst);
    EXPECT_LE(worst, 4e-15);
    EXPECT_GT(worst, 0);
}

TEST(Polished, MakesARotationOfWhatIsNearlyOne) {
    scene::Rng rng(11);
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
        Pose pose{rng.rotation(), rng.in_cube(3)};
        EXPECT_EQ(orthonormalised(pose, Vec3d::Zero()).rotation, pose.rotation)
            << "rounding alone changes nothing";
        const double off = std::ldexp(1.0, -static_cast<int>(rng.below(40)) - 5);
        for (int j = 0; j < 3; ++j) pose.rotation.col(j) += off * rng.in_cube(1);
        const Vec3d about = rng.in_cube(1e6);
        const Pose better = orthonormalised(pose, about);
        EXPECT_TRUE(is_orthonormalised(better));
        EXPECT_LT(norm(Vec3d(better.apply(about) - pose.apply(about))), 1e-8);
        worst = std::max(
            worst, (better.rotation - pose.rotation).cwiseAbs().maxCoeff() / ortho_error(pose.rotation));
    }
    std::printf("moved by at most %.3g of the distance from orthogonal\n", worst);
    EXPECT_LT(worst, 2);
}

}  // namespace
}  // namespace edgewise
