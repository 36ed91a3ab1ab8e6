// SPDX-License-Identifier: MIT
//
// From counts to figures, on counts made up here: disturbed and shared samples are dropped and told, the cost
// of counting is taken off, and what is too small becomes a reason, never a 0.
#include "edgewise/measure/counters/counter_arithmetic.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace edgewise::measure {
namespace {

CounterSample clean(std::uint64_t count) { return {count, 1000, 1000}; }

constexpr CountingCost cost{40, 50};

TEST(CounterArithmetic, TakesTheMedianLessTheOverheadPerQuery) {
    const std::vector samples{clean(5040), clean(9040), clean(4040), clean(5140), clean(4940)};
    const auto figure = count_per_query(samples, cost, 100);
    ASSERT_TRUE(figure.value) << figure.reason;
    EXPECT_DOUBLE_EQ(figure.value->per_query, 50);
    EXPECT_EQ(figure.value->samples, 5u);
    EXPECT_EQ(figure.value->dropped, 0u);
}

TEST(CounterArithmetic, DropsWhatWasDisturbedOrSharedItsCounter) {
    std::vector samples{clean(2040), clean(2040), clean(2040)};
    samples.push_back({900'000, 1000, 1000, 1, 0, 0});
    samples.push_back({900'000, 1000, 1000, 0, 1, 0});
    samples.push_back({900'000, 1000, 1000, 0, 0, 1});
    samples.push_back({900'000, 1000, 999});  // would be scaled by others
    const auto figure = count_per_query(samples, cost, 10);
    ASSERT_TRUE(figure.value) << figure.reason;
    EXPECT_DOUBLE_EQ(figure.value->per_query, 200);
    EXPECT_EQ(figure.value->samples, 3u);
    EXPECT_EQ(figure.value->dropped, 4u);
}

TEST(CounterArithmetic, RefusesTooFewGoodSamplesAndSaysWhyTheyWereBad) {
    const std::vector<CounterSample> samples{
        clean(2000), clean(2000), {2000, 9, 9, 3, 1, 0}, {2000, 9, 9, 0, 2, 1}, {2000, 9, 4}};
    const auto figure = count_per_query(samples, cost, 10);
    EXPECT_FALSE(figure.value);
    EXPECT_EQ(figure.reason,
              "of 5 samples only 2 are good: 1 had page faults, 2 context switches, 1 a change of the "
              "processor, 1 shared their counter");
    EXPECT_FALSE(figure.remedy.empty());
    EXPECT_FALSE(count_per_query({}, cost, 10).value);
}

/// Ten times the floor is 500, on top of the overhead of 40.
TEST(CounterArithmetic, RefusesWhatIsTooSmallInsteadOfGivingZero) {
    for (const std::uint64_t count : {0u, 1u, 39u, 40u, 41u, 539u}) {
        const std::vector samples(5, clean(count));
        const auto figure = count_per_query(samples, cost, 1000);
        EXPECT_FALSE(figure.value) << count;
        EXPECT_NE(figure.reason.find("below 0.5 per query"), std::string::npos) << figure.reason;
        EXPECT_FALSE(figure.remedy.empty());
    }
    const std::vector samples(5, clean(540));
    const auto figure = count_per_query(samples, cost, 1000);
    ASSERT_TRUE(figure.value);
    EXPECT_DOUBLE_EQ(figure.value->per_query, 0.5);
}

TEST(CounterArithmetic, ZeroIsRefusedEvenWhereCountingCostsNothing) {
    const auto free = counting_cost(std::vector<std::uint64_t>(100, 0));
    ASSERT_TRUE(free.value);
    EXPECT_EQ(free.value->overhead, 0u);
    EXPECT_EQ(free.value->floor, 1u);
    EXPECT_FALSE(count_per_query(std::vector(5, clean(0)), *free.value, 1000).value);
    EXPECT_FALSE(count_per_query(std::vector(5, clean(9)), *free.value, 1000).value);
    EXPECT_TRUE(count_per_query(std::vector(5, clean(10)), *free.value, 1000).value);
}

TEST(CounterArithmetic, NoQueriesGiveNoFigure) {
    const auto figure = count_per_query(std::vector(5, clean(10'000)), cost, 0);
    EXPECT_FALSE(figure.value);
    EXPECT_FALSE(figure.reason.empty());
}

TEST(CounterArithmetic, CostIsTheMedianOfManyAndItsFloorSeesMostOfThem) {
    std::vector<std::uint64_t> empty(100, 20);
    for (std::size_t i = 0; i < 15; ++i) empty[i] = 30;
    empty[50] = 1'000'000;  // an interrupt
    const auto found = counting_cost(empty);
    ASSERT_TRUE(found.value);
    EXPECT_EQ(found.value->overhead, 20u);
    EXPECT_EQ(found.value->floor, 30u);
    empty.pop_back();
    EXPECT_FALSE(counting_cost(empty).value);
    EXPECT_FALSE(counting_cost(empty).reason.empty());
}

}  // namespace
}  // namespace edgewise::measure
