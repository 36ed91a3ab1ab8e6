// SPDX-License-Identifier: MIT
//
// Groups of counters, tried with the kernel's own events, which are there without a PMU; and what the kernel
// may write for a group, made up here.
#include "edgewise/measure/counters/counter_group.hpp"

#include <gtest/gtest.h>
#include <linux/perf_event.h>

#include <cerrno>
#include <vector>

#include "counted_work.hpp"

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

}  // namespace
}  // namespace edgewise::measure
