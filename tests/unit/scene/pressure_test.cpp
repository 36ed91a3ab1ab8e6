// SPDX-License-Identifier: MIT
//
// The scene `pressure`: a table for every body, every pair of neighbours once a step, none of them touching.
#include <gtest/gtest.h>

#include <set>

#include "brute_force.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::scene {
namespace {

Workload pressure(std::size_t bodies, std::size_t queries) {
    auto workload =
        make_scene("pressure", *make_shape("sphere38"),
                   *complete_parameters("pressure", {{"bodies", double(bodies)}}), 1, queries, {});
    EXPECT_TRUE(workload) << workload.error;
    return std::move(*workload);
}

TEST(Pressure, AsksEveryPairOfNeighboursOnceAStep) {
    const std::size_t bodies = 30;
    const Workload w = pressure(bodies, 3 * (bodies - 1));
    EXPECT_TRUE(w.warm && w.table_each);
    EXPECT_EQ(w.instances.size(), bodies);
    EXPECT_EQ(w.pair_count, bodies - 1);
    for (std::size_t step = 0; step < 3; ++step) {
        std::set<std::uint32_t> pairs;
        for (std::size_t i = 0; i < bodies - 1; ++i) {
            const Query& q = w.queries[step * (bodies - 1) + i];
            EXPECT_TRUE(pairs.insert(q.pair).second);
            EXPECT_EQ(q.instance_b, q.instance_a + 1);
            EXPECT_EQ(q.instance_a, q.pair);
        }
    }
    EXPECT_NE(w.queries[0].pair + 1, w.queries[1].pair) << "an order that memory does not know";
    EXPECT_EQ(w.queries[0].pair, w.queries[bodies - 1].pair) << "the same order every step";
}

/// On the lattice all neighbours are equally far apart, and whatever way they turn they do not meet.
TEST(Pressure, PairsAreNearAndApart) {
    const Workload w = pressure(70, 138);
    double least = 1e9, most = 0;
    const double spacing = norm(Vec3d(w.queries[0].pose_a.translation - w.queries[0].pose_b.translation));
    for (const Query& q : w.queries) {
        const double d = truth::brute_force_distance(w.bodies[0], q.pose_a, w.bodies[0], q.pose_b);
        least = std::min(least, d);
        most = std::max(most, d);
        EXPECT_NEAR(norm(Vec3d(q.pose_a.translation - q.pose_b.translation)), spacing, 0.1);
    }
    EXPECT_GT(least, 0);
    EXPECT_LT(most, 0.5);
}

TEST(Pressure, TakesTheLeastSteps) {
    const auto w =
        make_scene("pressure", *make_shape("cube8"), {{"bodies", 30}, {"least_steps", 5}}, 1, 7, {});
    ASSERT_TRUE(w) << w.error;
    EXPECT_EQ(w->frames.size(), 5U);
    EXPECT_EQ(w->queries.size(), 5 * 29U);
}

}  // namespace
}  // namespace edgewise::scene
