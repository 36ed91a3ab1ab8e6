// SPDX-License-Identifier: MIT
//
// GJK on thin boxes where a face or an edge nearly lies along another, near contact and farther off: without
// wider arithmetic in each step, answers are as good as exact ones to within rounding, in either precision.
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

/// Returns a box of 0.1 to 1 by 1e-4 to 1 by 1e-4 to 1.
Polyhedron thin_box(scene::Rng& rng) {
    const auto half_side = [&](double least) { return 0.5 * std::pow(10.0, rng.uniform(least, 0)); };
    const double x = half_side(-1), y = half_side(-4), z = half_side(-4);
    std::vector<Vec3d> corners;
    for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z);
    return convex_hull(corners).or_throw();
}

template <class Table>
Distance ask(const Table& a, const Table& b, const Pose& pose) {
    SimplexPair<Table, Table> pair(a, b);
    return Gjk::query(a, b, {pose.rotation, pose.translation}, pair);
}

/// Numbers that both precisions have.
Pose in_single(const Pose& pose) {
    return {pose.rotation.cast<float>().cast<double>(), pose.translation.cast<float>().cast<double>()};
}

/// Every second pair is parallel to within 1e-12 to 1 rad. Their distance is near `gap`.
template <class Table>
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

/// Answers in one precision, compared with exact ones.
struct Tally {
    double step;  ///< of rounding
    double worst = 0;
    int separated = 0, wrong = 0;

    template <class Table>
    void add(const Polyhedron& body_a, const Polyhedron& body_b, const Table& a, const Table& b,
             const Pose& pose) {
        const auto exact = truth::exact_distance(body_a.vertices, Pose{}, body_b.vertices, pose).or_throw();
        const Distance answer = ask(a, b, pose);
        const double size =
            std::max({max_abs(body_a.vertices[0]), max_abs(body_b.vertices[0]), max_abs(pose.translation)});
        if (exact.distance > 45 * step * size) wrong += answer.status != Status::separated;
        if (answer.status != Status::separated) return;
        ++separated;
        worst = std::max(worst, std::abs(answer.distance - exact.distance) / size);
    }

    /// Four steps of the duality gap, four of the pose and the sums.
    void expect_within_rounding(int least) const {
        std::printf("%d separated, %d called in contact, worst error %.3g of the size\n", separated, wrong,
                    worst);
        EXPECT_GT(separated, least);
        EXPECT_EQ(wrong, 0);
        EXPECT_LE(worst, 8 * step);
    }
};

TEST(GjkNearContact, IsRightOnThinBoxesToWithinRounding) {
    scene::Rng rng(3);
    Tally in_double{Tolerance<double>::eps}, in_float{Tolerance<float>::eps};
    for (int i = 0; i < 16000; ++i) {
        const Polyhedron body_a = round_to_single(thin_box(rng)).or_throw(),
                         body_b = round_to_single(thin_box(rng)).or_throw();
        const points_soa<f64> a(body_a, Parts::support), b(body_b, Parts::support);
        const Pose pose = pose_at(std::pow(10.0, rng.uniform(-14, 0)), a, b, rng);
        in_double.add(body_a, body_b, a, b, pose);
        const points_soa<f32> single_a(body_a, Parts::support), single_b(body_b, Parts::support);
        in_float.add(body_a, body_b, single_a, single_b, in_single(pose));
    }
    in_double.expect_within_rounding(15000);
    in_float.expect_within_rounding(7000);
}

}  // namespace
}  // namespace edgewise
