// SPDX-License-Identifier: MIT
//
// Angles against libm, turns against the angle they were asked for, walls against the triangle wave.
#include "edgewise/scene/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "edgewise/scene/angle.hpp"
#include "edgewise/scene/rng.hpp"
#include "made_scene.hpp"

namespace edgewise::scene {
namespace {

double worst_error(double low, double high, int samples) {
    double worst = 0;
    for (int i = 0; i <= samples; ++i) {
        const double angle = low + (high - low) * i / samples;
        const SineCosine ours = sine_cosine(angle);
        worst =
            std::max({worst, std::abs(ours.sine - std::sin(angle)), std::abs(ours.cosine - std::cos(angle))});
    }
    return worst;
}

TEST(Angle, MatchesLibmUpToPi) {
    const double worst = worst_error(-std::numbers::pi, std::numbers::pi, 100000);
    std::printf("sine, cosine on [-pi, pi]: worst error %.2e\n", worst);
    EXPECT_LT(worst, 1e-15);
}

TEST(Angle, MatchesLibmFarBeyondAWholeTurn) {
    const double near = worst_error(-100, 100, 200000);
    const double far = worst_error(6.0e6, 6.5e6, 200000);
    std::printf("sine, cosine on [-100, 100]: worst error %.2e; near a million turns: %.2e\n", near, far);
    EXPECT_LT(near, 1e-15);
    EXPECT_LT(far, 1e-15);
}

TEST(Angle, SmallAnglesKeepTheirRelativeAccuracy) {
    double worst = 0;
    for (double angle = 1; angle > 1e-300; angle /= 3) {
        worst = std::max(worst, std::abs(sine_cosine(angle).sine / std::sin(angle) - 1));
    }
    std::printf("sine of small angles: worst relative error %.2e\n", worst);
    EXPECT_LT(worst, 1e-15);
    EXPECT_EQ(sine_cosine(0).sine, 0);
    EXPECT_EQ(sine_cosine(0).cosine, 1);
}

TEST(Motion, EveryStepTurnsByTheAskedAngleAboutTheAxis) {
    Rng rng(5);
    double worst = 0, worst_axis = 0;
    for (const double angle : {1e-6, 0.01, 0.3, 1.5, 3.0}) {
        const Vec3d axis = rng.on_sphere();
        MovingBody body{Vec3d::Zero(), Vec3d::Zero(), rng.orientation(), rotation_about(axis, angle)};
        for (int step = 0; step < 100; ++step) {
            const Mat3d before = rotation_matrix(body.orientation);
            advance(body, 1);
            const Mat3d after = rotation_matrix(body.orientation);
            worst = std::max(worst, std::abs(angle_between(before, after) - angle));
            const Vec3d in_body = multiply_transposed(before, axis);
            worst_axis = std::max(worst_axis, max_abs(Vec3d(multiply(after, in_body) - axis)));
        }
    }
    std::printf("step rotation: worst |measured - asked| %.1e rad, axis moved by %.1e\n", worst, worst_axis);
    EXPECT_LT(worst, 3e-15);
    EXPECT_LT(worst_axis, 3e-15);
}

TEST(Motion, AWholeTurnIsNone) {
    const Quaternion turn = rotation_about({0, 0, 1}, 2 * std::numbers::pi);
    const Mat3d r = rotation_matrix(turn);
    EXPECT_LT((r - Mat3d::Identity()).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Motion, OrientationStaysARotationForAMillionSteps) {
    Rng rng(6);
    MovingBody body{Vec3d::Zero(), Vec3d::Zero(), rng.orientation(), rotation_about(rng.on_sphere(), 0.01)};
    double worst = 0;
    for (int step = 0; step < 1000000; ++step) {
        advance(body, 1);
        worst = std::max(worst, std::abs(squared_norm(body.orientation) - 1));
    }
    const double ortho = ortho_error(rotation_matrix(body.orientation));
    std::printf("after 10^6 steps: worst | |q|^2 - 1 | %.1e, ortho error %.1e\n", worst, ortho);
    EXPECT_LT(worst, 1e-15);
    EXPECT_LT(ortho, 2e-15);
}

TEST(Motion, WallsReflectLikeATriangleWave) {
    const double half = 1.5;
    MovingBody body{{0.25, -1, 1.5}, {0.0625, -0.4375, 7.25}, {}, {}};
    const MovingBody start = body;
    int bounces = 0;
    for (int step = 1; step <= 500; ++step) {
        const Vec3d velocity = body.velocity;
        advance(body, half);
        bounces += (velocity.array() != body.velocity.array()).any();
        for (int axis = 0; axis < 3; ++axis) {
            // Unfolded, the path is a straight line; the fold has period four halves. All numbers are dyadic.
            const double line = start.centre[axis] + step * start.velocity[axis] + half;
            const double phase = line - 4 * half * std::floor(line / (4 * half));
            ASSERT_EQ(body.centre[axis], (phase <= 2 * half ? phase : 4 * half - phase) - half)
                << step << axis;
            ASSERT_EQ(std::abs(body.velocity[axis]), std::abs(start.velocity[axis]));
        }
    }
    std::printf("walls: %d of 500 steps bounced\n", bounces);
    EXPECT_GT(bounces, 100);
}

TEST(Motion, PoseTurnsAboutTheCentre) {
    Rng rng(8);
    const Vec3d centre(10, -20, 30), place(1, 2, 3);
    const Pose pose = pose_at(rng.rotation(), centre, place);
    EXPECT_LT(max_abs(Vec3d(pose.apply(centre) - place)), 1e-14);
}

}  // namespace
}  // namespace edgewise::scene
