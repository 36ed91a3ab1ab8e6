// SPDX-License-Identifier: MIT
//
// The scene `proximity`: pairs that stay where they are, a small gap apart, and turn by what was asked.
#include <gtest/gtest.h>

#include <cstdio>

#include "brute_force.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::scene {
namespace {

constexpr std::size_t pairs = 12, step_count = 60;

Workload proximity(const SceneParameters& more = {}) {
    SceneParameters given = {{"pairs", double(pairs)}};
    given.insert(more.begin(), more.end());
    auto workload = make_scene("proximity", *make_shape("sphere38"), *complete_parameters("proximity", given),
                               1, pairs * step_count, truth::brute_force_distance);
    EXPECT_TRUE(workload) << workload.error;
    return std::move(*workload);
}

double distance(const Workload& w, const Query& q) {
    return truth::brute_force_distance(w.bodies[0], q.pose_a, w.bodies[0], q.pose_b);
}

TEST(Proximity, StartsTheGapApart) {
    const Workload w = proximity();
    EXPECT_EQ(w.pair_count, pairs);
    EXPECT_EQ(w.instances.size(), 2 * pairs);
    EXPECT_EQ(w.frames.size(), step_count);
    const double size = extent(w.bodies[0].vertices);
    for (std::size_t i = 0; i < pairs; ++i)
        EXPECT_NEAR(distance(w, w.queries[i]), 0.001 * size, placement_tolerance * size) << "pair " << i;
}

/// The middles stay; a step turns by 0.25 / 60 rad, so that the pairs stay near, and some come to touch.
TEST(Proximity, StaysClose) {
    const Workload w = proximity();
    std::size_t touching = 0;
    double most = 0;
    for (std::size_t i = pairs; i < w.queries.size(); ++i) {
        const Query &now = w.queries[i], &before = w.queries[i - pairs];
        ASSERT_EQ(now.pair, before.pair);
        const Mat3d turn = now.pose_a.rotation * before.pose_a.rotation.transpose();
        EXPECT_NEAR(turn.trace(), 1 + 2 * std::cos(0.25 / 60), 1e-9);
        const double d = distance(w, now);
        touching += d == 0;
        most = std::max(most, d);
    }
    std::printf("%zu of %zu queries touch; farthest %.4f\n", touching, w.queries.size() - pairs, most);
    EXPECT_GT(touching, 0U);
    EXPECT_LT(touching, w.queries.size() / 2);
    EXPECT_LT(most, 0.3 * extent(w.bodies[0].vertices));
}

TEST(Proximity, StandsStillWithoutRotation) {
    const Workload w = proximity({{"rotation_step", 0}, {"gap", 0.1}});
    const double first = distance(w, w.queries[0]);
    EXPECT_EQ(distance(w, w.queries[(step_count - 1) * pairs]), first);
    EXPECT_NEAR(first, 0.1 * extent(w.bodies[0].vertices), 2e-3);
}

}  // namespace
}  // namespace edgewise::scene
