// SPDX-License-Identifier: MIT
//
// The normal of an answer compared with the exact direction between the closest points, down to gaps where
// the witness points say nothing of it any more.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "brute_depth.hpp"
#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "reference_table.hpp"

namespace edgewise {
namespace {

struct Placed {
    Pose pose;  ///< of B; A lies at the origin
    truth::ExactDistance truth;
    Vec3d normal;  ///< exact, from A to B
};

/// B next to A, about `gap` away, moved along the exact direction between them.
Placed place(const Polyhedron& a, const Polyhedron& b, double gap, scene::Rng& rng) {
    Placed placed;
    placed.pose = {rng.rotation(), 3 * rng.on_sphere()};
    for (int i = 0; i < 4; ++i) {
        placed.truth = *truth::exact_distance(a.vertices, {}, b.vertices, placed.pose);
        placed.normal = -placed.truth.separation / norm(placed.truth.separation);
        if (i < 3) placed.pose.translation -= (placed.truth.distance - gap) * placed.normal;
    }
    return placed;
}

template <class Algorithm, class Table>
Distance ask(const Table& a, const Table& b, const Pose& pose, const QueryOptions& options = {}) {
    typename Algorithm::template Pair<Table, Table> pair(a, b);
    return Algorithm::query(a, b, relative_pose({}, pose), pair, options);
}

/// Angles between found and exact, and how many are right to all digits.
struct Angles {
    double worst = 0, witnesses = 0, length = 0;
    int all_digits = 0;

    void take(const Distance& answer, const Vec3d& truth) {
        ASSERT_EQ(answer.status, Status::separated);
        const double error = norm(Vec3d(answer.normal - truth));
        const Vec3d offset = answer.point_b - answer.point_a;
        worst = std::max(worst, error);
        witnesses = std::max(witnesses, norm(Vec3d(offset / norm(offset) - truth)));
        length = std::max(length, std::abs(norm(answer.normal) - 1));
        all_digits += error < 8 * Tolerance<double>::eps;
    }
};

class Normal : public ::testing::TestWithParam<const char*> {};

/// Vertices are rounded, so between two of them no direction is better than the rounding over the gap. Faces
/// and crossing edges know theirs whatever the gap: at least a fifth of all pairs, of every shape.
TEST_P(Normal, IsTheExactDirectionBetweenTheBodies) {
    const Polyhedron body = *scene::make_shape(GetParam());
    const ReferenceTable table(body);
    constexpr int pairs = 200;
    for (const double gap : {1.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
        Angles gjk, vclip;
        scene::Rng rng(1);
        for (int i = 0; i < pairs; ++i) {
            const Placed placed = place(body, body, gap, rng);
            gjk.take(ask<Gjk>(table, table, placed.pose), placed.normal);
            vclip.take(ask<VClip>(table, table, placed.pose), placed.normal);
        }
        const double allowed = 8 * Tolerance<double>::eps * extent(body.vertices) / gap;
        for (const Angles& found : {gjk, vclip}) {
            std::printf("%s, gap %.0e: %.2g, %d to all digits; by witness points %.2g\n", GetParam(), gap,
                        found.worst, found.all_digits, found.witnesses);
            EXPECT_LT(found.worst, allowed + 8 * Tolerance<double>::eps);
            EXPECT_LT(found.length, 4 * Tolerance<double>::eps);
            EXPECT_GE(found.all_digits, pairs / 5);
        }
    }
}

TEST_P(Normal, InSingleIsAsGoodAsItsRounding) {
    const Polyhedron body = *scene::make_shape(GetParam());
    const testing::RoundedTable<f32> table(body);
    const Polyhedron stored = *round_to_single(body);
    scene::Rng rng(2);
    for (const double gap : {1.0, 1e-2, 1e-4}) {
        Angles found;
        for (int i = 0; i < 200; ++i) {
            const Placed placed = place(stored, stored, gap, rng);
            found.take(ask<Gjk>(table, table, placed.pose), placed.normal);
        }
        std::printf("%s in single, gap %.0e: %.2g\n", GetParam(), gap, found.worst);
        EXPECT_LT(found.worst, 8 * Tolerance<float>::eps * (1 + extent(body.vertices) / gap));
    }
}

/// Whatever is left undecided of the distance: a plane across the normal has one body on either side, and the
/// verdict takes fewer steps than the whole answer.
TEST_P(Normal, OfAVerdictSeparates) {
    const Polyhedron body = *scene::make_shape(GetParam());
    const ReferenceTable table(body);
    scene::Rng rng(3);
    int separated = 0, steps = 0, whole_steps = 0;
    for (int i = 0; i < 1000; ++i) {
        const Pose pose{rng.rotation(), rng.uniform(0.5, 2.5) * rng.on_sphere()};
        const Distance whole = ask<Gjk>(table, table, pose);
        const Distance answer = ask<Gjk>(table, table, pose, {.cutoff = 0});
        EXPECT_EQ(answer.status == Status::separated, whole.status == Status::separated);
        steps += answer.steps;
        whole_steps += whole.steps;
        if (answer.status != Status::separated) {
            EXPECT_EQ(answer.normal, Vec3d::Zero().eval()) << "in contact";
            continue;
        }
        ++separated;
        EXPECT_GE(answer.distance, whole.distance * (1 - 1e-12) - 2e-15) << "an upper bound";
        const testing::PointPair points{body.vertices, testing::moved(body, relative_pose({}, pose))};
        EXPECT_LT(points.reach(answer.normal), 0);
    }
    EXPECT_GT(separated, 200);
    EXPECT_LT(separated, 950);
    EXPECT_LT(steps, whole_steps);
}

/// Contact may begin at a distance: a direction that separates by less is no verdict yet.
TEST_P(Normal, OfAVerdictClearsTheTolerance) {
    const Polyhedron body = *scene::make_shape(GetParam());
    const ReferenceTable table(body);
    scene::Rng rng(4);
    int within = 0, separated = 0, steps = 0, whole_steps = 0;
    for (int i = 0; i < 1000; ++i) {
        const Pose pose{rng.rotation(), rng.uniform(1.5, 3) * rng.on_sphere()};
        const Distance whole = ask<Gjk>(table, table, pose, {.contact_tolerance = 0.4});
        const Distance answer = ask<Gjk>(table, table, pose, {.contact_tolerance = 0.4, .cutoff = 0});
        EXPECT_EQ(answer.status == Status::separated, whole.status == Status::separated) << whole.distance;
        within += whole.status != Status::separated && whole.distance > 0;
        separated += whole.status == Status::separated;
        steps += answer.steps;
        whole_steps += whole.steps;
    }
    EXPECT_GT(within, 100);
    EXPECT_GT(separated, 100);
    EXPECT_LT(steps, whole_steps);
}

TEST(NormalInTheWorld, TurnsWithBodyA) {
    Distance answer;
    answer.normal = {1, 0, 0};
    Pose pose;
    pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    pose.translation = {5, 6, 7};
    EXPECT_EQ(to_world(answer, pose).normal, Vec3d(0, 1, 0));
}

INSTANTIATE_TEST_SUITE_P(Shapes, Normal, ::testing::Values("tetra4", "cube8", "sphere38", "sphere386"),
                         [](const auto& shape) { return std::string(shape.param); });

}  // namespace
}  // namespace edgewise
