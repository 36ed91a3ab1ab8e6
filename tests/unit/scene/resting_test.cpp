// SPDX-License-Identifier: MIT
//
// `resting`: its statistics are those of recordings of engines, contacts last, several shapes are in use, and
// pairs at rest are not asked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <vector>

#include "edgewise/scene/kinds/scene_setup.hpp"
#include "made_scene.hpp"

namespace edgewise::scene {
namespace {

Workload resting(const char* shape, const SceneParameters& given = {}, std::size_t queries = 3000) {
    return made_scene("resting", *make_shape(shape), queries, given);
}

/// Relative turn of each pair from one query to the next.
std::vector<double> turns_of(const Workload& w) {
    std::vector<const Query*> last(w.pair_count, nullptr);
    std::vector<double> turns;
    for (const Query& q : w.queries) {
        const auto relative = [](const Query& of) { return relative_pose(of.pose_a, of.pose_b).rotation; };
        if (const Query* before = last[q.pair])
            turns.push_back(angle_between(relative(*before), relative(q)));
        last[q.pair] = &q;
    }
    std::ranges::sort(turns);
    return turns;
}

/// Recordings: 33 to 60 % of pairs overlap, 10 to 15 % are less than 1e-4 sizes apart, the median turn is
/// 1e-5 to 1e-3 rad per step, the 99th percentile 1.4 to 3.5 decades more, and 98 % of pairs persist.
TEST(Resting, HasTheStatisticsOfRecordings) {
    for (const char* name : {"cube8", "box8", "sphere38"}) {
        const Workload w = resting(name);
        ASSERT_EQ(w.queries.size(), 3000U);
        double overlapping = 0, very_near = 0, asked = 0;
        for (std::size_t i = 0; i < w.queries.size(); i += 5) {
            const double gap = distance_of(w, w.queries[i]) / (0.75 * extent(w.bodies[0].vertices));
            ++asked, overlapping += gap == 0, very_near += gap > 0 && gap < 1e-4;
        }
        const std::vector<double> turns = turns_of(w);
        const double median = turns[turns.size() / 2], most = turns[turns.size() * 99 / 100];
        const double could_persist = static_cast<double>(w.queries.size() - w.frames.at(1).first_query);
        const double persistent = static_cast<double>(turns.size()) / could_persist;
        std::printf(
            "resting %s: %.1f pairs per step, %.1f %% overlap, %.1f %% below 1e-4, turn %.1e, %.1e, "
            "%.2f %% persist\n",
            name, 3000.0 / static_cast<double>(w.frames.size()), 100 * overlapping / asked,
            100 * very_near / asked, median, most, 100 * persistent);
        EXPECT_GT(overlapping / asked, 0.33) << name;
        EXPECT_LT(overlapping / asked, 0.60) << name;
        EXPECT_GT(very_near / asked, 0.08) << name;
        EXPECT_LT(very_near / asked, 0.20) << name;
        EXPECT_GT(median, 1e-5) << name;
        EXPECT_LT(median, 1e-3) << name;
        EXPECT_GT(std::log10(most / median), 1.4) << name;
        EXPECT_LT(std::log10(most / median), 3.5) << name;
        EXPECT_GT(persistent, 0.98) << name;
    }
}

/// A turn about the vertical changes no height: bodies neither sink nor rise, whatever their speed.
TEST(Resting, ContactsLast) {
    const Workload w = resting("box8", {{"halvings", 0}});
    const std::vector<Aabb>&first = w.frames.front().boxes, &last = w.frames.at(5).boxes;
    double widest = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_NEAR(first[i].low.z(), last[i].low.z(), 1e-12);
        EXPECT_NEAR(first[i].high.z(), last[i].high.z(), 1e-12);
        widest = std::max(widest, std::abs(first[i].low.x() - last[i].low.x()));
    }
    EXPECT_GT(widest, 0.1) << "but they turn";
}

TEST(Resting, HasSeveralShapesEachSharedBySome) {
    const Workload w = resting("sphere38", {{"own_tables", 1}});
    EXPECT_TRUE(w.table_each);
    EXPECT_EQ(w.instances.size(), 61U);
    ASSERT_EQ(w.bodies.size(), 4U);
    for (std::uint32_t shape = 0; shape < 3; ++shape)
        EXPECT_GT(std::ranges::count(w.instances, shape), 10) << shape;
    EXPECT_EQ(std::ranges::count(w.instances, 3U), 1);
    EXPECT_EQ(w.instances.back(), 3U) << "figures of one table are of the first instance";
    EXPECT_GT(extent(w.bodies[3].vertices), 4 * extent(w.bodies[2].vertices));
    const auto on_the_cube = std::ranges::count_if(w.queries, [](const Query& q) { return q.body_b == 3; });
    EXPECT_NEAR(static_cast<double>(on_the_cube), 300, 150) << "of 3000";
}

TEST(Resting, PairsAtRestAreNotAsked) {
    const Workload w = resting("cube8", {{"asleep", 0.5}, {"halvings", 0}});
    const Frame &first = w.frames.at(0), &next = w.frames.at(1);
    std::set<std::uint32_t> at_rest;
    for (std::uint32_t i = 0; i < first.poses.size(); ++i)
        if (first.poses[i].rotation == next.poses[i].rotation) at_rest.insert(i);
    EXPECT_EQ(at_rest.size(), 31U) << "half of 12 towers of five, and the cube";
    std::size_t beside_one = 0;
    for (const Query& q : w.queries) {
        EXPECT_FALSE(at_rest.contains(q.instance_a) && at_rest.contains(q.instance_b));
        beside_one += at_rest.contains(q.instance_a) || at_rest.contains(q.instance_b);
    }
    EXPECT_GT(beside_one, 100U);
    SweepAndPrune all(first.boxes.size());
    EXPECT_GT(all.update(first.boxes).size(), next.first_query + 20) << "the broad phase finds them";
}

}  // namespace
}  // namespace edgewise::scene
