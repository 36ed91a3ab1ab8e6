// SPDX-License-Identifier: MIT
//
// Groups of counters, tried with the kernel's own events, which are there without a PMU; and what the kernel
// may write for a group, made up here.
#include <gtest/gtest.h>
#include <linux/perf_event.h>

#include <cerrno>
#include <string>
#include <vector>

#include "counted_work.hpp"
#include "edgewise/measure/counters/counter_group.hpp"

namespace edgewise::measure {
namespace {

TEST(CounterGroup, CountsEachEventFromZeroEveryTime) {
    CounterGroup group(std::vector{software_task_clock, software_page_faults});
    if (group.error() != 0) GTEST_SKIP() << "no software events here: errno " << group.error();
    for (const int pages : {300, 8, 0}) {
        ASSERT_TRUE(group.start());
        touch_pages(pages);
        const auto count = group.stop();
        ASSERT_TRUE(count.value) << count.reason;
        EXPECT_GE(count.value->values[1], static_cast<std::uint64_t>(pages));
        EXPECT_LE(count.value->values[1], static_cast<std::uint64_t>(pages) + 100);  // the sanitizers' own
        EXPECT_GT(count.value->values[0], 0u);
        EXPECT_GT(count.value->enabled_ns, 0u);
        EXPECT_EQ(count.value->running_ns, count.value->enabled_ns);
        EXPECT_LT(count.value->enabled_ns, 10'000'000'000u);
    }
}

TEST(CounterGroup, TakesOneToFourEvents) {
    EXPECT_EQ(CounterGroup(std::vector<EventCode>{}).error(), EINVAL);
    EXPECT_EQ(CounterGroup(std::vector(5, software_page_faults)).error(), EINVAL);
    CounterGroup four(std::vector(4, software_page_faults));
    if (four.error() != 0) GTEST_SKIP() << "no software events here: errno " << four.error();
    ASSERT_TRUE(four.start());
    touch_pages(7);
    const auto count = four.stop();
    ASSERT_TRUE(count.value) << count.reason;
    EXPECT_GE(count.value->values[0], 7u);
    for (const std::uint64_t value : count.value->values) EXPECT_EQ(value, count.value->values[0]);
}

TEST(CounterGroup, OneEventThatDoesNotExistClosesTheGroup) {
    CounterGroup group(std::vector{software_page_faults, {PERF_TYPE_SOFTWARE, 9999}});
    EXPECT_NE(group.error(), 0);
    EXPECT_FALSE(group.start());
    const auto count = group.stop();
    EXPECT_FALSE(count.value);
    EXPECT_FALSE(count.reason.empty());
}

constexpr std::int64_t bytes_of(std::size_t words) { return static_cast<std::int64_t>(words * 8); }

TEST(CounterGroup, ValuesAreTakenByTheirIds) {
    const std::vector<std::uint64_t> words{2, 100, 100, 11, 71, 22, 70};
    const auto count = parse_group(words, bytes_of(7), std::vector<std::uint64_t>{70, 71});
    ASSERT_TRUE(count.value) << count.reason;
    EXPECT_EQ(count.value->values[0], 22u);
    EXPECT_EQ(count.value->values[1], 11u);
}

TEST(CounterGroup, EndOfFileIsNoCount) {
    const std::vector<std::uint64_t> words(7, 0);
    const auto count = parse_group(words, 0, std::vector<std::uint64_t>{70, 71});
    EXPECT_FALSE(count.value);
    EXPECT_NE(count.reason.find("free counters"), std::string::npos) << count.reason;
    EXPECT_NE(count.remedy.find("nmi_watchdog"), std::string::npos) << count.remedy;
}

TEST(CounterGroup, AnythingOddIsNoCount) {
    const std::vector<std::uint64_t> ids{70, 71};
    const std::vector<std::uint64_t> words{2, 100, 100, 11, 71, 22, 70};
    EXPECT_FALSE(parse_group(words, -1, ids).value);
    EXPECT_FALSE(parse_group(words, bytes_of(5), ids).value);
    EXPECT_FALSE(
        parse_group(std::vector<std::uint64_t>{1, 100, 100, 11, 71, 22, 70}, bytes_of(7), ids).value);
    EXPECT_FALSE(
        parse_group(std::vector<std::uint64_t>{2, 100, 100, 11, 71, 22, 99}, bytes_of(7), ids).value);
}

TEST(CounterGroup, PartOfTheTimeIsRefusedNeverScaled) {
    EXPECT_TRUE(whole_time_only({{5}, 100, 100}).value);
    EXPECT_FALSE(whole_time_only({{5}, 100, 99}).value);
    EXPECT_FALSE(whole_time_only({{5}, 100, 0}).value);
    EXPECT_FALSE(whole_time_only({{5}, 0, 0}).value);
    EXPECT_EQ(whole_time_only({{5}, 100, 50}).reason,
              "on the counters for only 50 of 100 ns, and a scaled count is a guess");
}

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
