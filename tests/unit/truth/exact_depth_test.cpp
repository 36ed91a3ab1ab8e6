// SPDX-License-Identifier: MIT
//
// Exact penetration depth: against closed forms, against plain enumeration in machine integers, against every
// separating axis of random solids in double, and against exact_distance after moving the bodies by the
// depth.
#include "edgewise/truth/depth/exact_depth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

const Points unit_box = box({0, 0, 0}, {1, 1, 1});

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
    // R v + t is no double here, and the depth is below what the vertices can tell.
    EXPECT_EQ(ask(unit_box, Points{{1, 0.5, 0.5}}, {}, moved({-0x1p-105, 0, 0})).depth, 0x1p-105);
    EXPECT_EQ(ask(unit_box, unit_box).depth, 1);
    EXPECT_EQ(ask(unit_box, box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.75})).depth, 0.5);
    EXPECT_EQ(ask(unit_box, Points{{0.5, 0.5, 0.75}}).depth, 0.25);
    // The corner x + y + z <= 1 against a cube whose corner reaches into it along the slanted face.
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

using Whole = Vec3<long>;

/// The least h^2 / n.n over all planes through three points of A - B that bound it; h counts from the origin.
struct Quotient {
    long top = 1;
    long bottom = 0;
};

Quotient enumerate(const std::vector<Whole>& points) {
    Quotient least;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            for (std::size_t k = j + 1; k < points.size(); ++k) {
                const Whole n = cross(Whole(points[j] - points[i]), Whole(points[k] - points[i]));
                if (n.isZero()) continue;
                const long height = dot(n, points[i]);
                long low = 0, high = 0;
                for (const Whole& p : points) {
                    low = std::min(low, dot(n, p) - height);
                    high = std::max(high, dot(n, p) - height);
                }
                if (low < 0 && high > 0) continue;
                const long square = dot(n, n);
                if (height * height * least.bottom < least.top * square || least.bottom == 0)
                    least = {height * height, square};
            }
        }
    }
    return least;
}

TEST(ExactDepth, agrees_with_enumeration_on_a_grid) {
    RandomBodies random(21);
    const auto grid_points = [&](std::size_t count) {
        Points points;
        for (std::size_t i = 0; i < count; ++i) {
            const auto digit = [&] { return static_cast<double>(random.bits()() % 5) - 2; };
            const double x = digit(), y = digit(), z = digit();
            points.emplace_back(x, y, z);
        }
        return points;
    };
    int deep = 0, touching = 0, flat = 0;
    for (int i = 0; i < 2500; ++i) {
        const Points a = grid_points(1 + random.bits()() % 6);
        const Points b = grid_points(1 + random.bits()() % 5);
        const Result<ExactDepth> exact = exact_depth(a, {}, b, {});
        if (!exact) continue;
        std::vector<Whole> difference;
        for (const Vec3d& p : a) {
            for (const Vec3d& q : b) difference.push_back(Vec3d(p - q).cast<long>());
        }
        const Quotient least = enumerate(difference);
        const double quotient =
            least.bottom == 0 ? 0 : static_cast<double>(least.top) / static_cast<double>(least.bottom);
        ASSERT_NEAR(exact->depth, std::sqrt(quotient), 4e-16 * exact->depth) << "pair " << i;
        deep += exact->depth > 0;
        touching += exact->depth == 0 && least.bottom > 0;
        flat += least.bottom == 0;
    }
    std::printf("grid: %d deep, %d touching or in a plane, %d on a line\n", deep, touching, flat);
    EXPECT_GT(deep, 500);
    EXPECT_GT(touching, 100);
    EXPECT_GT(flat, 3);
}

}  // namespace
}  // namespace edgewise::truth
