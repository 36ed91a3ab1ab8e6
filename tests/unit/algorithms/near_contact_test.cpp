// SPDX-License-Identifier: MIT
//
// GJK near contact, below 2^-10 of the size, on thin boxes where a face or an edge nearly lies along another:
// without wider arithmetic in each step, answers are as good as exact ones to within rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/layouts/points_soa.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise {
namespace {

using Table = points_soa<f64>;

/// Returns a box of 0.1 to 1 by 1e-4 to 1 by 1e-4 to 1.
Polyhedron thin_box(scene::Rng& rng) {
    const auto half_side = [&](double least) { return 0.5 * std::pow(10.0, rng.uniform(least, 0)); };
    const double x = half_side(-1), y = half_side(-4), z = half_side(-4);
    std::vector<Vec3d> corners;
    for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z);
    return convex_hull(corners).or_throw();
}

Distance ask(const Table& a, const Table& b, const Pose& pose) {
    SimplexPair<Table, Table> pair(a, b);
    return Gjk::query(a, b, {pose.rotation, pose.translation}, pair);
}

/// Every second pair is parallel to within 1e-12 to 1 rad. Their distance is near `gap`.
Pose pose_at(double gap, const Table& a, const Table& b, scene::Rng& rng) {
    Pose pose;
    pose.rotation =
        rng.below(2)
            ? rng.rotation()
            : rotation_matrix(scene::rotation_about(rng.on_sphere(), std::pow(10.0, rng.uniform(-12, 0))));
    pose.translation = 3 * rng.on_sphere();
    for (int i = 0; i < 3; ++i) {
        const Distance answer = ask(a, b, pose);
        if (answer.status == Status::separated) pose.translation -= (answer.distance - gap) * answer.normal;
    }
    return pose;
}

TEST(GjkNearContact, IsRightOnThinBoxesToWithinRounding) {
    scene::Rng rng(3);
    double worst = 0;
    int separated = 0, wrong = 0;
    for (int i = 0; i < 8000; ++i) {
        const Polyhedron body_a = thin_box(rng), body_b = thin_box(rng);
        const Table a(body_a, Parts::support), b(body_b, Parts::support);
        const Pose pose = pose_at(std::pow(10.0, rng.uniform(-14, -3.8)), a, b, rng);
        const auto exact = truth::exact_distance(body_a.vertices, Pose{}, body_b.vertices, pose).or_throw();
        const Distance answer = ask(a, b, pose);
        const double size =
            std::max({max_abs(body_a.vertices[0]), max_abs(body_b.vertices[0]), max_abs(pose.translation)});
        if (exact.distance > 1e-14 * size) wrong += answer.status != Status::separated;
        if (answer.status != Status::separated) continue;
        ++separated;
        worst = std::max(worst, std::abs(answer.distance - exact.distance) / size);
    }
    std::printf("%d separated, %d called in contact, worst error %.3g of the size\n", separated, wrong,
                worst);
    EXPECT_GT(separated, 7000);
    EXPECT_EQ(wrong, 0);
    // Four steps of the duality gap, four of the pose and the sums.
    EXPECT_LE(worst, 8 * Tolerance<double>::eps);
}

}  // namespace
}  // namespace edgewise
