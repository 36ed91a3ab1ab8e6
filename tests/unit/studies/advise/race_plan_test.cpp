// SPDX-License-Identifier: MIT
//
// How much of a race fits into a time: never more than fits, and as much as does.
#include "edgewise/studies/advise/race_plan.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace edgewise::studies::advise
