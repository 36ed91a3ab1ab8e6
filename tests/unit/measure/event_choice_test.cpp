// SPDX-License-Identifier: MIT
//
// From a metric to an event: processors told apart by their numbers, the order in which events are tried, and
// what is said when there is none. No counter is needed for any of it.
#include "edgewise/measure/counters/event_choice.hpp"

#include <gtest/gtest.h>
#include <linux/perf_event.h>

#include <cerrno>
#include <set>
#include <string>
#include <tuple>

#include "edgewise/measure/counters/event_table.hpp"
#include "edgewise/measure/machine/processor.hpp"

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

std::string pmu_of(const Cpu& cpu) {
    const Processor* const processor = find_processor(cpu);
    return processor == nullptr ? "" : std::string(processor->pmu);
}

TEST(EventProcessor, IsToldByItsNumbers) {
    EXPECT_EQ(pmu_of(cpu_of("GenuineIntel", 6, 0x5e)), "skl");
    EXPECT_EQ(pmu_of(cpu_of("GenuineIntel", 6, 0x55, 4)), "skx");
    EXPECT_EQ(pmu_of(cpu_of("GenuineIntel", 6, 0x55, 7)), "clx");
    EXPECT_EQ(pmu_of(cpu_of("GenuineIntel", 6, 0x6a)), "icx");
    EXPECT_EQ(pmu_of(cpu_of("GenuineIntel", 6, 0x8f)), "spr");
    EXPECT_EQ(pmu_of(cpu_of("AuthenticAMD", 0x17, 0x31)), "amd64_fam17h_zen2");
    EXPECT_EQ(pmu_of(cpu_of("AuthenticAMD", 0x19, 0x01)), "amd64_fam19h_zen3");
    EXPECT_EQ(pmu_of(cpu_of("AuthenticAMD", 0x19, 0x50)), "amd64_fam19h_zen3");
    EXPECT_EQ(pmu_of(cpu_of("AuthenticAMD", 0x19, 0x11)), "amd64_fam19h_zen4");
    EXPECT_EQ(pmu_of(cpu_of("AuthenticAMD", 0x19, 0x61)), "amd64_fam19h_zen4");
    EXPECT_EQ(pmu_of(cpu_of("AuthenticAMD", 0x1a, 0x02)), "amd64_fam1ah_zen5");
    EXPECT_EQ(pmu_of(cpu_of("AuthenticAMD", 6, 4)), "amd64_k7");
    EXPECT_EQ(pmu_of(cpu_of("0x41", 8, 0xd0c)), "arm_n1");
    EXPECT_EQ(pmu_of(cpu_of("0x41", 8, 0xd4f)), "arm_v2");
    // Zen 1, a hybrid processor, another maker's of the same numbers, and one that nothing is known of.
    EXPECT_EQ(pmu_of(cpu_of("AuthenticAMD", 0x17, 0x01)), "");
    EXPECT_EQ(pmu_of(cpu_of("GenuineIntel", 6, 0x97)), "");
    EXPECT_EQ(pmu_of(cpu_of("HygonGenuine", 0x18, 0x31)), "");
    EXPECT_EQ(pmu_of(cpu_of("SomebodyElse", 6, 0x5e)), "");
    EXPECT_EQ(pmu_of(Cpu{}), "");
}

TEST(EventTable, HasOneRowAMetricAndProcessorAndSaysWhatItCounts) {
    std::set<std::tuple<Metric, unsigned>> seen;
    for (const EventRow& row : event_table()) {
        EXPECT_NE(row.generations, 0u) << row.name;
        for (unsigned bit = 1; bit <= generation::k7; bit <<= 1) {
            if ((row.generations & bit) == 0) continue;
            EXPECT_TRUE(seen.emplace(row.metric, bit).second) << row.name << " twice for " << bit;
        }
        EXPECT_FALSE(row.name.empty() || row.counts.empty()) << row.name;
        EXPECT_EQ(row.name.find("::"), std::string_view::npos) << row.name;
    }
    // Every one of the processors has at least these; K7 has few.
    for (const Processor& processor : processors()) {
        for (const Metric metric : {Metric::instructions, Metric::cycles, Metric::branches,
                                    Metric::branch_misses, Metric::l1d_fills, Metric::dtlb_walks}) {
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

TEST(EventChoice, AGenericEventIsTakenOnlyWhereItCountsTheSame) {
    const auto cache_misses = PERF_COUNT_HW_CACHE_MISSES;
    const auto generic = [](Metric metric, CpuMaker maker) { return find_generic(metric, maker); };
    ASSERT_NE(generic(Metric::llc_misses, CpuMaker::intel), nullptr);
    EXPECT_EQ(generic(Metric::llc_misses, CpuMaker::intel)->code.config, cache_misses);
    // "cache-misses" is the second level on AMD, the first on Arm.
    EXPECT_EQ(generic(Metric::llc_misses, CpuMaker::amd), nullptr);
    ASSERT_NE(generic(Metric::l2_demand_misses, CpuMaker::amd), nullptr);
    EXPECT_EQ(generic(Metric::l2_demand_misses, CpuMaker::amd)->code.config, cache_misses);
    EXPECT_EQ(generic(Metric::l2_demand_misses, CpuMaker::arm), nullptr);
    ASSERT_NE(generic(Metric::llc_misses, CpuMaker::arm), nullptr);
    EXPECT_NE(generic(Metric::llc_misses, CpuMaker::arm)->code.config, cache_misses);
    EXPECT_EQ(generic(Metric::l1d_load_misses, CpuMaker::intel), nullptr);
    EXPECT_EQ(generic(Metric::stores, CpuMaker::amd), nullptr);
    ASSERT_NE(generic(Metric::instructions, CpuMaker::other), nullptr);
}

TEST(EventChoice, ANewProcessorStillHasTheGenericOnes) {
    for (const MetricName& metric : {metrics[0], metrics[1]}) {
        const auto found = event_candidates(metric, cpu_of("AuthenticAMD", 0x1b, 0));
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].by, "generic");
        EXPECT_EQ(found[0].level, "core");
    }
}

TEST(EventChoice, NoEventIsSaidWithWhereItWouldBe) {
    const MetricName crossing = metrics.back();
    ASSERT_EQ(crossing.metric, Metric::line_crossing_loads);
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
