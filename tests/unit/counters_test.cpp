// SPDX-License-Identifier: MIT
//
// The counter inventory: counted means counted, and what is not counted is null with a reason and a remedy.
#include "edgewise/measure/counters.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdio>
#include <optional>
#include <set>
#include <string>

#include "edgewise/measure/machine_json.hpp"

namespace edgewise {
namespace {

using nlohmann::json;

TEST(Counters, AreCountedOrNullWithReasonAndRemedy) {
    const json counters = machine_json()["counters"];
    std::set<std::string> names;
    int counted = 0;
    for (const json& c : counters) {
        const std::string text = c.dump();
        names.insert(c.at("event").get<std::string>());
        EXPECT_FALSE(c.at("encoding").get<std::string>().empty()) << text;
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
    EXPECT_EQ(names,
              (std::set<std::string>{"instructions", "cycles", "cache-references", "cache-misses",
                                     "branch-misses", "L1-dcache-load-misses", "dTLB-load-misses",
                                     "page-faults", "context-switches", "cpu-migrations", "task-clock"}));
    EXPECT_EQ(counters.size(), names.size());
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
        if (record.event == "L1-dcache-load-misses") {
            EXPECT_GE(*record.value, 1u);
        }
    }
}

TEST(Counters, LevelDependsOnTheMaker) {
    const auto level_of = [](const char* vendor, const char* event) -> std::optional<std::string> {
        Cpu cpu;
        cpu.vendor.value = vendor;
        for (const CounterRecord& record : read_counters(cpu)) {
            if (record.event == event) return record.level;
        }
        return "no such event";
    };
    EXPECT_EQ(level_of("GenuineIntel", "cache-misses"), "LLC");
    EXPECT_EQ(level_of("AuthenticAMD", "cache-misses"), "L2");
    EXPECT_EQ(level_of("0x41", "cache-misses"), "L1D");
    EXPECT_EQ(level_of("NobodyKnows", "cache-misses"), std::nullopt);
    EXPECT_EQ(level_of("NobodyKnows", "instructions"), "core");
    EXPECT_EQ(level_of("NobodyKnows", "page-faults"), "kernel");
}

TEST(Counters, EveryErrorHasAReasonAndARemedy) {
    const auto explained = [](int error, bool hardware, bool guest) {
        Cpu cpu;
        cpu.hypervisor.value = guest;
        CounterRecord record;
        record.error = error;
        record.value = 5;
        explain_error(record, hardware, cpu);
        EXPECT_FALSE(record.value);
        EXPECT_FALSE(record.reason.empty() || record.remedy.empty()) << error;
        return record.reason + " | " + record.remedy;
    };
    std::set<std::string> texts;
    for (const int error : {EACCES, ENOENT, ENOSYS, EMFILE, EIO}) texts.insert(explained(error, true, false));
    texts.insert(explained(ENOENT, true, true));
    EXPECT_EQ(texts.size(), 6u);  // different causes, different advice
    EXPECT_NE(explained(ENOENT, true, true).find("virtual machine"), std::string::npos);
    EXPECT_EQ(explained(ENOENT, true, false).find("virtual machine"), std::string::npos);
    EXPECT_EQ(explained(ENOENT, false, true).find("virtual machine"), std::string::npos);
    EXPECT_NE(explained(EACCES, true, true).find("perf_event_paranoid"), std::string::npos);
}

}  // namespace
}  // namespace edgewise
