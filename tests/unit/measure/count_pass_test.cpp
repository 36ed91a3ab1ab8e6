// SPDX-License-Identifier: MIT
//
// Counting over passes, and the inventory of counters. Events of the kernel replace those of the processor,
// so that all code is tested on a machine without counters. If there are no events, no pass is run and every
// metric is unavailable, with a reason and a remedy.
#include "edgewise/measure/counters/count_pass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "counted_work.hpp"
#include "edgewise/measure/counters/counter_group.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/measure/machine/machine_json.hpp"

namespace edgewise::measure {
namespace {

using nlohmann::json;

ChosenEvent stand_in(const char* name, const EventCode& code) {
    ChosenEvent event;
    event.event = name;
    event.by = "software";
    event.encoding = encoding_text(code);
    event.code = code;
    return event;
}

ChosenEvent unavailable(const char* name) {
    ChosenEvent event;
    event.event = name;
    event.by = "libpfm";
    event.error = ENOENT;
    event.refusal = {"not here", "look elsewhere"};
    return event;
}

/// Some milliseconds that cause neither a fault nor a system call.
void compute() {
    volatile unsigned x = 1;
    for (unsigned i = 0; i < 1'000'000; ++i) x = x * 3 + i;
}

bool is_said(const PassRecord& record) {
    return record.value.has_value() != !record.refusal.reason.empty() &&
           record.refusal.reason.empty() == record.refusal.remedy.empty();
}

TEST(CountPass, WithoutAnyEventThePassIsNeverRun) {
    std::vector<ChosenEvent> events;
    for (const MetricName& metric : metrics) events.push_back(unavailable(metric.name.data()));
    int calls = 0;
    const CountedPass counted = count_events([&] { ++calls; }, 1000, events);
    EXPECT_EQ(calls, 0);
    EXPECT_EQ(counted.passes, 0u);
    ASSERT_EQ(counted.records.size(), metrics.size());
    for (const PassRecord& record : counted.records) {
        EXPECT_FALSE(record.value) << record.event;
        EXPECT_EQ(record.error, ENOENT);
        EXPECT_EQ(record.refusal.reason, "not here");
        EXPECT_EQ(record.refusal.remedy, "look elsewhere");
    }
}

TEST(CountPass, TellsEveryMetricOfThisMachine) {
    const Cpu cpu = read_machine().cpu;
    std::size_t calls = 0;
    const CountedPass counted = count_pass(
        [&] {
            ++calls;
            compute();
        },
        1000, cpu);
    EXPECT_EQ(counted.passes, calls);
    ASSERT_EQ(counted.records.size(), metrics.size());
    bool any_counted = false;
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        const PassRecord& record = counted.records[i];
        EXPECT_EQ(record.event, metrics[i].name);
        EXPECT_TRUE(is_said(record)) << record.event;
        EXPECT_NE(record.value.value_or(1), 0) << record.event;
        any_counted = any_counted || record.floor > 0;
    }
    const std::vector<ChosenEvent>& chosen = chosen_events(cpu);
    const bool any_open = std::any_of(chosen.begin(), chosen.end(),
                                      [](const ChosenEvent& event) { return event.refusal.reason.empty(); });
    EXPECT_EQ(calls > 0, any_counted);
    EXPECT_TRUE(any_open || calls == 0);
    EXPECT_EQ(&chosen_events(cpu), &chosen);  // found out once
}

TEST(CountPass, CountsAndDividesByQueries) {
    const std::vector<ChosenEvent> events{stand_in("clock", software_task_clock), unavailable("gone")};
    std::size_t calls = 0;
    CountOptions options;
    options.most_passes = 60;
    const CountedPass counted = count_events(
        [&] {
            ++calls;
            compute();
        },
        10, events, options);
    EXPECT_EQ(counted.passes, calls);
    ASSERT_EQ(counted.records.size(), 2u);
    const PassRecord& clock = counted.records[0];
    EXPECT_TRUE(is_said(clock)) << clock.refusal.reason;
    if (clock.value) {
        EXPECT_GT(*clock.value, 1e4);  // a million steps take above 0.1 ms
        EXPECT_GE(clock.samples, 3u);
        EXPECT_EQ(clock.samples + clock.dropped, calls);
        EXPECT_GT(clock.overhead, 0u);
    }
    EXPECT_FALSE(counted.records[1].value);
}

/// Each pass faults, so that no sample is good; and it says so.
TEST(CountPass, DisturbedPassesGiveAReason) {
    const std::vector events{stand_in("clock", software_task_clock)};
    std::size_t calls = 0;
    const CountedPass counted = count_events(
        [&] {
            ++calls;
            touch_pages(3);
        },
        10, events);
    const PassRecord& clock = counted.records.at(0);
    EXPECT_FALSE(clock.value);
    EXPECT_FALSE(clock.refusal.remedy.empty());
    EXPECT_EQ(calls, clock.floor > 0 ? CountOptions{}.most_passes : 0);
    if (calls > 0) {
        EXPECT_NE(clock.refusal.reason.find("12 had page faults"), std::string::npos) << clock.refusal.reason;
    }
}

/// An undisturbed pass has no page fault: too few to be a value, and not a 0.
TEST(CountPass, NothingCountedIsNotZero) {
    const std::vector events{stand_in("page-faults", software_page_faults)};
    const CountedPass counted = count_events(compute, 10, events);
    EXPECT_FALSE(counted.records.at(0).value);
    EXPECT_FALSE(counted.records.at(0).refusal.reason.empty());
}

/// The second does not exist: the group of three fails, halves of it still count.
TEST(CountPass, AGroupThatFailsIsHalved) {
    const std::vector<ChosenEvent> events{stand_in("clock", software_task_clock),
                                          stand_in("nonsense", {PERF_TYPE_SOFTWARE, 9999}),
                                          stand_in("clock again", software_task_clock)};
    const CountedPass counted = count_events(compute, 10, events);
    ASSERT_EQ(counted.records.size(), 3u);
    for (const PassRecord& record : counted.records) EXPECT_TRUE(is_said(record)) << record.event;
    EXPECT_FALSE(counted.records[1].value);
    EXPECT_EQ(counted.records[1].floor, 0u);  // never calibrated
    EXPECT_EQ(counted.records[0].floor > 0, counted.records[2].floor > 0);
    if (CounterGroup(std::vector{software_task_clock}).error() == 0) {
        EXPECT_GT(counted.records[0].floor, 0u);
    }
}

TEST(CountSoftware, SeesTheFaultsOfOnePass) {
    int calls = 0;
    const auto records = count_software(
        [&] {
            ++calls;
            touch_pages(50);
        },
        10, Cpu{});
    EXPECT_EQ(calls, 1);
    ASSERT_EQ(records.size(), 4u);
    EXPECT_EQ(records[0].event, "minor_faults");
    EXPECT_GE(records[0].value.value_or(0), 5.0);
    EXPECT_LE(records[0].value.value_or(0), 15.0);  // the sanitizers' own
    EXPECT_EQ(records[1].event, "major_faults");
    EXPECT_EQ(records[2].event, "context_switches");
    EXPECT_EQ(records[3].event, "cpu_migrations");
    for (const PassRecord& record : records) EXPECT_TRUE(is_said(record)) << record.event;
    for (const PassRecord& record : count_software([] {}, 0, Cpu{})) EXPECT_FALSE(record.value);
}

TEST(CountSoftware, SteadyWorkHasNoFaults) {
    // The system may take away a page at any time, but not each time.
    bool steady = false;
    for (int attempt = 0; attempt < 5 && !steady; ++attempt) {
        const auto records = count_software(compute, 10, Cpu{});
        ASSERT_EQ(records.size(), 4u);
        steady = records[0].value == 0.0 && records[1].value == 0.0;  // here 0 is what was counted
    }
    EXPECT_TRUE(steady);
}

TEST(Counters, AreCountedOrNullWithReasonAndRemedy) {
    const json counters = machine_json()["counters"];
    std::set<std::string> names, by;
    for (const json& c : counters) {
        const std::string text = c.dump();
        names.insert(c.at("event").get<std::string>());
        EXPECT_FALSE(c.at("encoding").get<std::string>().empty()) << text;
        EXPECT_FALSE(c.at("meaning").get<std::string>().empty()) << text;
        by.insert(c.at("by").get<std::string>());
        EXPECT_TRUE(c.at("level").is_string() || c.at("level").is_null()) << text;
        if (c.at("status") == "counted") {
            EXPECT_TRUE(c.at("value").is_number_unsigned()) << text;
            EXPECT_TRUE(c.at("errno").is_null() && c.at("reason").is_null() && c.at("remedy").is_null())
                << text;
        } else {
            EXPECT_EQ(c.at("status"), "unavailable") << text;
            EXPECT_TRUE(c.at("value").is_null()) << text;
            EXPECT_TRUE(c.at("errno").is_null() || c.at("errno").get<int>() > 0) << text;
            EXPECT_FALSE(c.at("reason").get<std::string>().empty()) << text;
            EXPECT_FALSE(c.at("remedy").get<std::string>().empty()) << text;
        }
    }
    std::set<std::string> expected{"page-faults",      "minor-faults",   "major-faults",
                                   "context-switches", "cpu-migrations", "task-clock"};
    for (const MetricName& metric : metrics) expected.emplace(metric.name);
    EXPECT_EQ(names, expected);
    EXPECT_EQ(counters.size(), names.size());
    for (const std::string& way : by) {
        EXPECT_TRUE((std::set<std::string>{"libpfm", "generic", "software", "none"}.count(way))) << way;
    }
}

/// What the work must cause cannot have been counted 0 times.
TEST(Counters, CountedOnesSawTheReferenceWork) {
    const std::map<std::string, std::uint64_t> least = {
        {"page-faults", 256}, {"context-switches", 1}, {"instructions", 100'000}, {"l1d_fills", 1}};
    for (const CounterRecord& record : read_counters(Cpu{})) {
        EXPECT_EQ(record.value.has_value(), record.refusal.reason.empty()) << record.event;
        if (!record.value) continue;
        const auto found = least.find(record.event);
        EXPECT_GE(*record.value, found != least.end() ? found->second : std::uint64_t{record.must_happen})
            << record.event;
    }
}

}  // namespace
}  // namespace edgewise::measure
