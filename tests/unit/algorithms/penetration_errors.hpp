// SPDX-License-Identifier: MIT
//
// Asking for a penetration depth, and how far an answer is from what it claims.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "brute_depth.hpp"
#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/penetration.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::testing {

[[nodiscard]] inline Polyhedron box(double x, double y, double z) {
    std::vector<Vec3d> corners;
    for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z);
    return *convex_hull(corners);
}

template <class Table>
[[nodiscard]] Penetration ask(const Polyhedron& a, const Polyhedron& b, const Transform<double>& pose,
                              const SimplexPair<Table, Table>& start) {
    PenetrationSpace space;
    return penetration(Table(a), Table(b), pose, start, space);
}

/// Penetration after GJK, from its last simplex.
template <class Table = Canonical>
[[nodiscard]] Penetration ask(const Polyhedron& a, const Polyhedron& b, const Transform<double>& pose) {
    SimplexPair<Table, Table> pair;
    (void)Gjk::query(Table(a), Table(b), pose, pair);
    return ask<Table>(a, b, pose, pair);
}

[[nodiscard]] inline Transform<double> shifted(double x, double y, double z) {
    return {Mat3d::Identity(), Vec3d(x, y, z)};
}

/// How far an answer is from what it claims, over the size of the pair; the worst of several.
struct Errors {
    double depth = 0, normal = 0, witness = 0, outside = 0;

    void take(const Polyhedron& a, const Polyhedron& b, const Transform<double>& pose,
              const Penetration& answer, double expected) {
        const double scale = extent(a.vertices) + extent(b.vertices) + norm(pose.translation);
        const PointPair points{a.vertices, moved(b, pose)};
        const Vec3d between = answer.point_a - answer.point_b;
        const Vec3d b_in_own_frame = pose.direction_back(Vec3d(answer.point_b - pose.translation));
        EXPECT_TRUE(answer.converged);
        EXPECT_NEAR(norm(answer.normal), 1, 1e-15);
        EXPECT_GE(answer.depth, 0);
        raise(depth, std::abs(answer.depth - expected) / scale);
        raise(normal, std::abs(points.reach(answer.normal) - answer.depth) / scale);
        raise(witness, norm(Vec3d(between - answer.depth * answer.normal)) / scale);
        raise(outside,
              std::max(how_far_outside(a, answer.point_a), how_far_outside(b, b_in_own_frame)) / scale);
    }

    void print(const char* what) const {
        std::printf(
            "penetration, %s: worst depth %.2g, support along the normal %.2g, witness difference "
            "%.2g, witness outside %.2g of size\n",
            what, depth, normal, witness, outside);
    }

    void expect_below(double limit) const {
        EXPECT_LT(depth, limit);
        EXPECT_LT(normal, limit);
        EXPECT_LT(witness, limit);
        EXPECT_LT(outside, limit);
    }

  private:
    /// NaN counts as the worst.
    static void raise(double& worst, double error) {
        if (!(error <= worst)) worst = error;
    }
};

/// B somewhere along a random line, up to where it leaves A; one in three shallow.
[[nodiscard]] inline Transform<double> random_overlap(const Polyhedron& a, const Polyhedron& b,
                                                      scene::Rng& rng) {
    Transform<double> pose{rng.rotation(), Vec3d::Zero()};
    const Vec3d direction = rng.on_sphere();
    const double exit = brute_exit(a, b, pose, direction);
    const double part =
        rng.below(3) == 0 ? 1 - std::ldexp(rng.uniform(), -static_cast<int>(rng.below(30))) : rng.uniform();
    pose.translation = part * exit * direction;
    return pose;
}

}  // namespace edgewise::testing
