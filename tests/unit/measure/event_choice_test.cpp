// SPDX-License-Identifier: MIT
//
// The event for a metric: processors by their numbers, the order in which events are tried, and the refusal
// if there is none. No counter is needed for these tests.
#include "edgewise/measure/counters/events.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace edgewise::measure {
namespace {

Cpu cpu_of(const char* vendor, std::int64_t family, std::int64_t model, std::int64_t stepping = 0) {
    Cpu cpu;
    cpu.vendor.value = vendor;
    cpu.family.value = family;
    cpu.model.value = model;
    cpu.stepping.value = stepping;
    return cpu;
}

TEST(EventProcessor, IsKnownByItsNumbers) {
    const std::pair<Cpu, const char*> cases[] = {
        {cpu_of("GenuineIntel", 6, 0x5e), "skl"},
        {cpu_of("GenuineIntel", 6, 0x55, 4), "skx"},
        {cpu_of("GenuineIntel", 6, 0x55, 7), "clx"},
        {cpu_of("GenuineIntel", 6, 0x6a), "icx"},
        {cpu_of("GenuineIntel", 6, 0x8f), "spr"},
        {cpu_of("AuthenticAMD", 0x17, 0x31), "amd64_fam17h_zen2"},
        {cpu_of("AuthenticAMD", 0x19, 0x01), "amd64_fam19h_zen3"},
        {cpu_of("AuthenticAMD", 0x19, 0x50), "amd64_fam19h_zen3"},
        {cpu_of("AuthenticAMD", 0x19, 0x11), "amd64_fam19h_zen4"},
        {cpu_of("AuthenticAMD", 0x19, 0x61), "amd64_fam19h_zen4"},
        {cpu_of("AuthenticAMD", 0x1a, 0x02), "amd64_fam1ah_zen5"},
        {cpu_of("AuthenticAMD", 6, 4), "amd64_k7"},
        {cpu_of("0x41", 8, 0xd0c), "arm_n1"},
        {cpu_of("0x41", 8, 0xd4f), "arm_v2"},
        // Zen 1, a hybrid processor, another maker's of the same numbers, and an unknown one.
        {cpu_of("AuthenticAMD", 0x17, 0x01), ""},
        {cpu_of("GenuineIntel", 6, 0x97), ""},
        {cpu_of("HygonGenuine", 0x18, 0x31), ""},
        {cpu_of("SomebodyElse", 6, 0x5e), ""},
        {Cpu{}, ""},
    };
    for (const auto& [cpu, pmu] : cases) {
        const Processor* const processor = find_processor(cpu);
        EXPECT_EQ(processor ? processor->pmu : "", pmu);
    }
}

TEST(EventTable, HasOneRowAMetricAndProcessorAndSaysWhatItCounts) {
    std::set<std::tuple<std::string_view, std::string_view>> seen;
    for (const EventRow& row : event_table()) {
        EXPECT_FALSE(row.generations.empty()) << row.name;
        for (const std::string& generation : row.generations) {
            EXPECT_GT(std::ranges::count(processors(), generation, &Processor::generation), 0) << generation;
            EXPECT_TRUE(seen.emplace(row.metric.name, generation).second)
                << row.name << " twice for " << generation;
        }
        EXPECT_FALSE(row.name.empty() || row.counts.empty()) << row.name;
        EXPECT_EQ(row.name.find("::"), std::string_view::npos) << row.name;
    }
    // Every one of the processors has at least these; K7 has few.
    for (const Processor& processor : processors()) {
        for (const char* metric :
             {"instructions", "cycles", "branches", "branch_misses", "l1d_fills", "dtlb_walks"}) {
            EXPECT_NE(find_event(metric, processor.generation), nullptr) << processor.pmu;
        }
    }
}

TEST(EventChoice, TriesTheProcessorsOwnBeforeTheGeneric) {
    for (const MetricName& metric : metrics) {
        const auto found = event_candidates(metric, cpu_of("GenuineIntel", 6, 0x55, 4));
        int last = 0;
        for (const ChosenEvent& event : found) {
            const int rank = event.by == "libpfm" ? 1 : event.by == "generic" ? 2 : 0;
            EXPECT_GT(rank, last) << metric.name << " by " << event.by;
            last = rank;
            EXPECT_EQ(event.event, metric.name);
            EXPECT_FALSE(event.encoding.empty() || event.meaning.empty());
            EXPECT_EQ(event.level, metric.level);
        }
    }
}

/// "cache-misses" is the last level on Intel, the second level on AMD and the first on Arm.
TEST(EventChoice, AGenericEventIsTakenOnlyWhereItCountsTheSame) {
    const std::tuple<std::string_view, CpuMaker, const char*> cases[] = {
        {"llc_misses", CpuMaker::intel, "CACHE-MISSES"},
        {"llc_misses", CpuMaker::amd, ""},
        {"llc_misses", CpuMaker::arm, "LLC-LOAD-MISSES"},
        {"l2_demand_misses", CpuMaker::amd, "CACHE-MISSES"},
        {"l2_demand_misses", CpuMaker::arm, ""},
        {"l1d_load_misses", CpuMaker::intel, ""},
        {"stores", CpuMaker::amd, ""},
        {"instructions", CpuMaker::other, "INSTRUCTIONS"},
    };
    for (const auto& [metric, maker, name] : cases) {
        const GenericEvent* const event = find_generic(metric, maker);
        EXPECT_EQ(event ? event->name : "", name) << metric;
    }
}

/// A new processor still has the generic events; without libpfm the refusal says so.
TEST(EventChoice, ANewProcessorStillHasTheGenericOnes) {
    const Cpu zen6 = cpu_of("AuthenticAMD", 0x1b, 0);
    for (const MetricName& metric : {metrics[0], metrics[1]}) {
        const auto found = event_candidates(metric, zen6);
        if (why_no_libpfm().empty()) {
            ASSERT_EQ(found.size(), 1u);
            EXPECT_EQ(found[0].by, "generic");
            EXPECT_EQ(found[0].level, "core");
        } else {
            EXPECT_TRUE(found.empty());
            EXPECT_EQ(choose_event(metric, zen6).refusal.reason, why_no_libpfm());
        }
    }
}

TEST(EventChoice, NoEventIsSaidWithWhereItWouldBe) {
    const MetricName crossing = metrics.back();
    ASSERT_EQ(crossing.name, "line_crossing_loads");
    for (const Cpu& cpu : {cpu_of("AuthenticAMD", 0x17, 0x31), cpu_of("0x41", 8, 0xd0c), Cpu{}}) {
        const ChosenEvent event = choose_event(crossing, cpu);
        EXPECT_EQ(event.by, "none");
        EXPECT_EQ(event.error, 0);
        EXPECT_FALSE(event.level);
        EXPECT_NE(event.refusal.reason.find("no event"), std::string::npos) << event.refusal.reason;
        EXPECT_NE(event.refusal.remedy.find("AMD Zen 3"), std::string::npos) << event.refusal.remedy;
        EXPECT_EQ(event.refusal.remedy.find("AMD Zen 2"), std::string::npos) << event.refusal.remedy;
    }
}

TEST(EventChoice, EveryErrorHasAReasonAndARemedy) {
    const auto explained = [](int error, bool hardware, bool guest) {
        Cpu cpu;
        cpu.hypervisor.value = guest;
        const Refusal refusal = explain_error(error, hardware, cpu);
        EXPECT_FALSE(refusal.reason.empty() || refusal.remedy.empty()) << error;
        return refusal.reason + " | " + refusal.remedy;
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
}  // namespace edgewise::measure
