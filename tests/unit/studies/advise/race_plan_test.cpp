// SPDX-License-Identifier: MIT
//
// How much of a race fits into a time: never more than fits, and as much as does.
#include "edgewise/studies/advise/screen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "edgewise/scene/rng.hpp"

namespace edgewise::studies::advise {

namespace {

TEST(RacePlan, CountsEveryPart) {
    EXPECT_DOUBLE_EQ(race_seconds({2, 0.1, 5}, {3, 25}), 4 * (2 + 25 * 0.1) + 5)
        << "three processes, and one more part for bodies that fit the cache";
}

TEST(RacePlan, IsWholeWhereThereIsTime) {
    const RacePlan plan = race_within(1000, {2, 0.1, 5});
    EXPECT_EQ(plan.processes, 3);
    EXPECT_EQ(plan.rounds, 25);
}

TEST(RacePlan, GivesUpRoundsBeforeProcesses) {
    const RacePlan plan = race_within(4 * (2 + 7.5 * 0.1) + 5, {2, 0.1, 5});
    EXPECT_EQ(plan.processes, 3);
    EXPECT_EQ(plan.rounds, 7);
}

TEST(RacePlan, IsTheLargestThatFits) {
    scene::Rng rng(11);
    std::set<int> processes, rounds;
    int least = 0;
    for (int trial = 0; trial < 5000; ++trial) {
        const RaceCost cost{rng.uniform(0.01, 5), rng.uniform(0.001, 1), rng.uniform(0, 10)};
        const double seconds = rng.uniform(0.1, 60);
        const RacePlan plan = race_within(seconds, cost);
        processes.insert(plan.processes);
        rounds.insert(plan.rounds);
        ASSERT_GE(plan.processes, least_race.processes);
        ASSERT_LE(plan.processes, whole_race.processes);
        ASSERT_GE(plan.rounds, least_race.rounds);
        ASSERT_LE(plan.rounds, whole_race.rounds);
        if (race_seconds(cost, plan) > seconds) {
            ++least;
            EXPECT_EQ(plan.processes, least_race.processes);
            EXPECT_EQ(plan.rounds, least_race.rounds);
            continue;
        }
        if (plan.rounds < whole_race.rounds) {
            EXPECT_GT(race_seconds(cost, {plan.processes, plan.rounds + 1}), seconds);
        }
        if (plan.processes < whole_race.processes) {
            EXPECT_GT(race_seconds(cost, {plan.processes + 1, least_race.rounds}), seconds);
        }
    }
    EXPECT_EQ(processes.size(), 3U);
    EXPECT_EQ(rounds.size(), 21U);
    EXPECT_GT(least, 100);
}

// Pieces of work under a limit, by a clock of the test's own: one is begun only where one as long as the
// longest so far still ends in time.

TEST(TimeLimit, LooksAtTheLongestPieceSoFar) {
    double now = 0;
    TimeLimit limit([&] { return now; }, 10);
    EXPECT_TRUE(limit.begin_piece());
    now = 3;
    EXPECT_TRUE(limit.begin_piece());
    now = 4;
    EXPECT_TRUE(limit.begin_piece()) << "until 7, if it is as long as the first";
    now = 6.9;
    EXPECT_TRUE(limit.begin_piece());
    EXPECT_NEAR(limit.left(), 3.1, 1e-12);
    now = 7;
    EXPECT_FALSE(limit.begin_piece()) << "until 10";
    now = 11;
    EXPECT_FALSE(limit.begin_piece());
    EXPECT_LT(limit.left(), 0);
}

/// Over the end goes only a piece longer than all before it, and never a second one.
TEST(TimeLimit, IsExceededByNoMoreThanAPieceThatNobodyCouldForesee) {
    scene::Rng rng(5);
    int kept = 0, exceeded = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        double now = 0, longest = 0, last = 0;
        const double end = rng.uniform(0.5, 20);
        TimeLimit limit([&] { return now; }, end);
        while (limit.begin_piece()) {
            ASSERT_LE(now, end);
            longest = std::max(longest, last);
            last = rng.uniform(0.1, 2);
            now += last;
        }
        ++(now <= end ? kept : exceeded);
        if (now > end) {
            EXPECT_GT(last, longest);
        }
    }
    EXPECT_GT(kept, 100);
    EXPECT_GT(exceeded, 100);
}

// A prediction from made-up misses. Sums were done by hand.

TEST(Prediction, WaitsForEachLevel) {
    CacheCost cost;
    cost.in_cache_ns = 100;
    cost.misses = {{this_machine, {10, 4}}, {"one_level", {10}}, {"three_levels", {10, 4, 1}}};
    predict(cost, std::vector<double>{5, 80});  // the second level, memory
    EXPECT_DOUBLE_EQ(cost.predicted_ns.at(this_machine), 100 + 6 * 5 + 4 * 80);
    EXPECT_DOUBLE_EQ(cost.predicted_ns.at("one_level"), 100 + 10 * 80);
    EXPECT_DOUBLE_EQ(cost.predicted_ns.at("three_levels"), 100 + 6 * 5 + 3 * 80 + 1 * 80);
}

TEST(Prediction, IsNoneWithoutLatenciesOrTheTimeInCache) {
    CacheCost cost;
    cost.misses = {{this_machine, {10, 4}}};
    predict(cost, std::vector<double>{5, 80});
    cost.in_cache_ns = 100;
    predict(cost, {});
    EXPECT_TRUE(cost.predicted_ns.empty());
}

}  // namespace

}  // namespace edgewise::studies::advise
