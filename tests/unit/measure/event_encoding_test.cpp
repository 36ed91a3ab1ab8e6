// SPDX-License-Identifier: MIT
//
// The event table against libpfm: it knows each row's name, for processors that this machine is not. An
// event's name or unit mask that libpfm does not have is an error.
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <linux/perf_event.h>
#include <perfmon/pfmlib.h>

#include <algorithm>
#include <set>
#include <string>

#include "edgewise/measure/counters/events.hpp"

namespace edgewise::measure {
namespace {

std::set<std::string> known_pmus() {
    EXPECT_EQ(why_no_libpfm(), "");
    std::set<std::string> names;
    for (int i = 0; i < PFM_PMU_MAX; ++i) {
        pfm_pmu_info_t info{};
        info.size = sizeof info;
        if (pfm_get_pmu_info(static_cast<pfm_pmu_t>(i), &info) == PFM_SUCCESS) names.insert(info.name);
    }
    return names;
}

TEST(EventEncoding, LibpfmKnowsEveryRow) {
    const std::set<std::string> pmus = known_pmus();
    std::size_t checked = 0;
    std::string lacking;
    for (const Processor& processor : processors()) {
        if (!pmus.contains(std::string(processor.pmu))) {
            lacking += fmt::format(" {}", processor.pmu);
            continue;
        }
        for (const EventRow& row : event_table()) {
            if (std::ranges::count(row.generations, processor.generation) == 0) continue;
            const Expected<EventCode> code = encode_by_libpfm(fmt::format("{}::{}", processor.pmu, row.name));
            ASSERT_TRUE(code.value) << code.reason;
            EXPECT_EQ(code.value->type, static_cast<std::uint32_t>(PERF_TYPE_RAW));
            EXPECT_FALSE(code.value->kernel_too);
            ++checked;
        }
    }
    fmt::print("libpfm encodes {} rows of the table; it lacks{}\n", checked,
               lacking.empty() ? " no processor of the table" : lacking);
    // Ten x86 processors since 4.13 (2023); libpfm holds those of one architecture.
    EXPECT_GE(checked, pmus.contains("skx") ? 100u : 10u);
}

TEST(EventEncoding, LibpfmKnowsEveryGenericEvent) {
    const auto code_of = [](std::string_view name) {
        return encode_by_libpfm(fmt::format("perf::{}", name));
    };
    for (const MetricName& metric : metrics) {
        for (const CpuMaker maker : {CpuMaker::intel, CpuMaker::amd, CpuMaker::arm, CpuMaker::other}) {
            const GenericEvent* const event = find_generic(metric.name, maker);
            if (event == nullptr) continue;
            const Expected<EventCode> code = code_of(event->name);
            ASSERT_TRUE(code.value) << code.reason;
            EXPECT_TRUE(code.value->type == PERF_TYPE_HARDWARE || code.value->type == PERF_TYPE_HW_CACHE);
        }
    }
    EXPECT_EQ(encoding_text(*code_of("CACHE-MISSES").value), "PERF_TYPE_HARDWARE:0x3:u");
    EXPECT_EQ(encoding_text(*code_of("LLC-LOAD-MISSES").value), "PERF_TYPE_HW_CACHE:0x10002:u");
}

TEST(EventEncoding, AWrongUnitMaskOrNameIsSeen) {
    if (!known_pmus().contains("skx")) GTEST_SKIP() << "this libpfm has no x86 processors";
    const auto code = encode_by_libpfm("skx::MEM_LOAD_RETIRED:L1_MISS");
    ASSERT_TRUE(code.value);
    EXPECT_EQ(code.value->config, 0x8d1U);  // Intel's manual
    for (const char* name :
         {"skx::MEM_LOAD_RETIRED:L9_MISS", "skx::MEM_LOADS_RETIRED:L1_MISS",
          "nosuch::MEM_LOAD_RETIRED:L1_MISS", "amd64_fam17h_zen2::MISALIGNED_LOADS:MA64"}) {
        const Expected<EventCode> wrong = encode_by_libpfm(name);
        EXPECT_FALSE(wrong.value) << name;
        EXPECT_NE(wrong.reason.find(name), std::string::npos) << wrong.reason;
    }
}

TEST(EventEncoding, ServersOfTwoMakersAreAskedForTheirOwnEvents) {
    if (!known_pmus().contains("skx")) GTEST_SKIP() << "this libpfm has no x86 processors";
    Cpu skx, desktop_zen4;
    skx.vendor.value = "GenuineIntel";
    skx.family.value = 6;
    skx.model.value = 0x55;
    skx.stepping.value = 4;
    desktop_zen4.vendor.value = "AuthenticAMD";
    desktop_zen4.family.value = 0x19;
    desktop_zen4.model.value = 0x61;
    for (const auto& [cpu, pmu] : {std::pair(skx, "skx::"), std::pair(desktop_zen4, "amd64_fam19h_zen4::")}) {
        for (const MetricName& metric : metrics) {
            const auto found = event_candidates(metric, cpu);
            ASSERT_FALSE(found.empty()) << metric.name;
            EXPECT_EQ(found[0].by, "libpfm") << metric.name;
            EXPECT_TRUE(found[0].encoding.starts_with(pmu)) << found[0].encoding;
        }
    }
}

/// This libpfm has no events of Arm: the generic ones are left, and what has none is refused with its name.
TEST(EventEncoding, WithoutTheProcessorsNamesTheGenericEventsAreLeft) {
    if (known_pmus().contains("arm_n1")) GTEST_SKIP() << "this libpfm has the processor";
    Cpu arm;
    arm.vendor.value = "0x41";
    arm.family.value = 8;
    arm.model.value = 0xd0c;
    EXPECT_EQ(event_candidates(metrics[0], arm).at(0).by, "generic");
    for (const MetricName& metric : metrics) {
        if (metric.name != "stores") continue;
        EXPECT_TRUE(event_candidates(metric, arm).empty());
        const ChosenEvent event = choose_event(metric, arm);
        EXPECT_NE(event.refusal.reason.find("arm_n1::MEM_ACCESS_WR"), std::string::npos)
            << event.refusal.reason;
        EXPECT_NE(event.refusal.remedy.find("libpfm4"), std::string::npos);
    }
}

}  // namespace
}  // namespace edgewise::measure
