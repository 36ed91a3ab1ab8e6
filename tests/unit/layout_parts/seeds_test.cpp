// SPDX-License-Identifier: MIT
//
// Seeds beside a plain maximum over all vertices; and what they save a cold query.
#include "edgewise/layout_parts/seeds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/lean_seeds.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise {
namespace {

/// layout_parts may not include algorithms, so each has the number for itself: a cold climb asks a table of
/// so many vertices for a seed, and the table has one from so many on.
static_assert(seeds_from == scan_cold_below);

Vec3d axis_of(int place) { return Vec3d(place / 9 - 1, place / 3 % 3 - 1, place % 3 - 1); }

TEST(Seeds, ADirectionsPlaceIsTheNearestOfTwentySix) {
    scene::Rng rng(1);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d direction = rng.on_sphere() * std::exp2(rng.uniform(-60, 60));
        const Vec3d axis = axis_of(static_cast<int>(seed_place(direction)));
        ASSERT_GT(squared_norm(axis), 0);
        const double cosine = dot(direction, axis) / norm(direction) / norm(axis);
        worst = std::max(worst, std::acos(std::min(1.0, cosine)));
    }
    std::printf("farthest from its axis: %.3f rad\n", worst);
    EXPECT_LT(worst, 0.53);
    EXPECT_EQ(seed_place(Vec3d(0, 0, 0)), 13U);
    for (int place = 0; place < 27; ++place) EXPECT_EQ(seed_place(axis_of(place)), static_cast<Index>(place));
}

template <class Table>
void expect_highest(const Polyhedron& body) {
    const Table table(body, Parts::features);
    for (int place = 0; place < 27; ++place) {
        if (place == 13) continue;
        const auto direction = cast<ComputeOf<Table>>(axis_of(place));
        const auto height = [&](Index v) { return dot(table.vertex(v), direction); };
        const Index seed = table.seed(direction);
        ASSERT_LT(seed, body.vertex_count());
        for (Index v = 0; v < body.vertex_count(); ++v) EXPECT_LE(height(v), height(seed)) << place;
    }
}

TEST(Seeds, AreTheFarthestVertices) {
    for (const char* shape : {"sphere38", "sphere386", "sphere1538"}) {  // 8 and 16 bits
        const Polyhedron body = scene::make_shape(shape).or_throw();
        expect_highest<lean_seeds<f64>>(body);
        expect_highest<lean_seeds<f32>>(stored_body<lean_seeds<f32>>(body).or_throw());
    }
}

/// Poses of a body beside itself, in any orientation, from almost touching to a body's size between them.
template <class Algorithm, class Table>
double mean_cold_steps(const Polyhedron& body) {
    using Pair = typename Algorithm::template Pair<Table, Table>;
    const Table table(body, Algorithm::parts);
    scene::Rng rng(2);
    double steps = 0;
    constexpr int count = 500;
    for (int i = 0; i < count; ++i) {
        Transform<double> pose;
        pose.rotation = rng.rotation();
        pose.translation = rng.on_sphere() * rng.uniform(2.01, 4);
        Pair cold(table, table);
        const Distance answer = Algorithm::query(table, table, pose, cold);
        EXPECT_EQ(answer.status, Status::separated);
        steps += answer.steps;
    }
    return steps / count;
}

TEST(Seeds, SaveAColdVClipMostOfItsWalk) {
    for (const char* shape : {"sphere38", "sphere386", "sphere1538"}) {
        const Polyhedron body = scene::make_shape(shape).or_throw();
        const double with = mean_cold_steps<VClip, lean_seeds<f64>>(body);
        const double without = mean_cold_steps<VClip, lean<f64>>(body);
        std::printf("%s: %.1f states with seeds, %.1f without\n", shape, with, without);
        EXPECT_LT(with, 8) << shape;
        EXPECT_LT(with, without) << shape;
    }
}

}  // namespace
}  // namespace edgewise
