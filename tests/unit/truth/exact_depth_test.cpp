// SPDX-License-Identifier: MIT
//
// Exact penetration depth against closed forms: boxes, contacts, flat bodies, bad input.
#include "edgewise/truth/exact_proof.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

ExactDepth ask(const Points& a, const Points& b, const Pose& pose_a = {}, const Pose& pose_b = {}) {
    const Result<ExactDepth> answer = exact_depth(a, pose_a, b, pose_b);
    EXPECT_TRUE(answer) << answer.error;
    return answer ? *answer : ExactDepth{};
}

TEST(ExactDepth, boxes_at_dyadic_offsets) {
    for (const double depth : {0.25, 0x1p-30, 0x1p-52}) {
        const ExactDepth along_x = ask(unit_box, unit_box, {}, moved({1 - depth, 0.5, 0}));
        EXPECT_EQ(along_x.depth, depth);
        EXPECT_EQ(along_x.normal, Vec3d(1, 0, 0));
        const ExactDepth below = ask(unit_box, unit_box, {}, moved({0, 0.5, depth - 1}));
        EXPECT_EQ(below.depth, depth);
        EXPECT_EQ(below.normal, Vec3d(0, 0, -1));
    }
    // R v + t is no double here, and the depth is below the rounding of the vertices.
    EXPECT_EQ(ask(unit_box, Points{{1, 0.5, 0.5}}, {}, moved({-0x1p-105, 0, 0})).depth, 0x1p-105);
    EXPECT_EQ(ask(unit_box, unit_box).depth, 1);
    EXPECT_EQ(ask(unit_box, box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.75})).depth, 0.5);
    EXPECT_EQ(ask(unit_box, Points{{0.5, 0.5, 0.75}}).depth, 0.25);
    // The corner x + y + z <= 1 against a cube with a corner that reaches into it along the slanted face.
    const Points corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const ExactDepth slanted = ask(corner, box({0.25, 0.25, 0.25}, {2, 2, 2}));
    EXPECT_EQ(slanted.depth, std::sqrt(0.0625 / 3));
    EXPECT_EQ(slanted.normal, Vec3d::Constant(0.57735026918962576451));
}

TEST(ExactDepth, touching_and_flat_are_zero) {
    const ExactDepth face = ask(unit_box, unit_box, {}, moved({0.25, -1, 0.5}));
    EXPECT_EQ(face.depth, 0);
    EXPECT_EQ(face.normal, Vec3d(0, -1, 0));
    EXPECT_EQ(ask(unit_box, unit_box, {}, moved({1, 1, 1})).depth, 0);
    const Points square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const Points line = {{0.5, 0.5, -1}, {0.5, 0.5, 1}};
    const Points point = {{0.5, 0.5, 0}};
    const ExactDepth coplanar = ask(square, square, {}, moved({0.5, 0.5, 0}));
    EXPECT_EQ(coplanar.depth, 0);
    EXPECT_EQ(coplanar.normal.cwiseAbs(), Vec3d(0, 0, 1));
    for (const Points& flat : {line, point}) {
        const ExactDepth same = ask(flat, flat);
        EXPECT_EQ(same.depth, 0);
        EXPECT_EQ(norm(same.normal), 1);
    }
    EXPECT_EQ(ask(line, line).normal.z(), 0);
    // A segment through a square can leave through its side or be pulled out.
    EXPECT_EQ(ask(square, line).depth, 0.5);
    EXPECT_EQ(ask(square, line, {}, moved({0.25, 0, 0.875})).depth, 0.125);
}

TEST(ExactDepth, says_what_is_wrong) {
    EXPECT_NE(exact_depth(unit_box, {}, unit_box, moved({3, 0, 0})).error.find("2 apart"), std::string::npos);
    EXPECT_FALSE(exact_depth({}, {}, unit_box, {}).error.empty());
    const Points bad = {{0, std::numeric_limits<double>::quiet_NaN(), 0}};
    EXPECT_NE(exact_depth(unit_box, {}, bad, {}).error.find("vertex 0 is not finite"), std::string::npos);
}

}  // namespace
}  // namespace edgewise::truth
