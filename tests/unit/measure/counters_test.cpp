// SPDX-License-Identifier: MIT
//
// The counter inventory: counted means counted, and what is not counted is null with a reason and a remedy.
#include "edgewise/measure/counters/counters.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>
#include <string>

#include "edgewise/measure/machine/machine_json.hpp"

namespace edgewise::measure {
namespace {

using nlohmann::json;

TEST(Counters, AreCountedOrNullWithReasonAndRemedy) {
    const json counters = machine_json()["counters"];
    std::set<std::string> names, by;
    int counted = 0;
    for (const json& c : counters) {
        const std::string text = c.dump();
        names.insert(c.at("event").get<std::string>());
        EXPECT_FALSE(c.at("encoding").get<std::string>().empty()) << text;
        EXPECT_FALSE(c.at("meaning").get<std::string>().empty()) << text;
        by.insert(c.at("by").get<std::string>());
        EXPECT_TRUE(c.at("level").is_string() || c.at("level").is_null()) << text;
        if (c.at("status") == "counted") {
            ++counted;
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
    std::printf("%d of %zu events are counted here\n", counted, counters.size());
}

TEST(Counters, CountedOnesSawTheReferenceWork) {
    for (const CounterRecord& record : read_counters(Cpu{})) {
        if (!record.value) continue;
        if (record.event == "page-faults") {
            EXPECT_GE(*record.value, 256u);
        }
        if (record.event == "context-switches") {
            EXPECT_GE(*record.value, 1u);
        }
        if (record.event == "instructions") {
            EXPECT_GE(*record.value, 100'000u);
        }
        if (record.event == "l1d_fills") {
            EXPECT_GE(*record.value, 1u);
        }
    }
}

/// What the work must cause cannot have been counted 0 times.
TEST(Counters, WhatMustHappenIsNeverZero) {
    for (const CounterRecord& record : read_counters(Cpu{})) {
        EXPECT_EQ(record.value.has_value(), record.refusal.reason.empty()) << record.event;
        if (record.must_happen && record.value) {
            EXPECT_GT(*record.value, 0u) << record.event;
        }
    }
}

}  // namespace
}  // namespace edgewise::measure
