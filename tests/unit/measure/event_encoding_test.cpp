// SPDX-License-Identifier: MIT
//
// The event table against libpfm: each row's name is encoded again, for processors that this machine is not,
// through libpfm's switches LIBPFM_ENCODE_INACTIVE and LIBPFM_FORCE_PMU. A name or a unit mask that libpfm
// does not have, or another code, is an error.
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <linux/perf_event.h>
#include <perfmon/pfmlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>

#include "edgewise/measure/counters/event_choice.hpp"
#include "edgewise/measure/counters/event_table.hpp"
#include "edgewise/measure/counters/libpfm.hpp"

namespace edgewise::measure {
namespace {

/// Runs `check` in a child process whose libpfm starts with a switch set: once read, it stays set.
template <class Check>
void with_switch(const char* name, const char* value, Check check) {
    std::fflush(stdout);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        setenv(name, value, 1);
        static_cast<void>(why_no_libpfm());  // the first start is the library's own
        pfm_terminate();
        EXPECT_EQ(pfm_initialize(), PFM_SUCCESS);
        check();
        std::fflush(stdout);
        _exit(testing::Test::HasFailure() ? 1 : 0);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "see the child's messages above";
}

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

std::string full_name(const Processor& processor, const EventRow& row) {
    return fmt::format("{}::{}", processor.pmu, row.name);
}

void check_every_row() {
    const std::set<std::string> pmus = known_pmus();
    std::size_t checked = 0;
    std::string lacking;
    for (const Processor& processor : processors()) {
        if (!pmus.contains(std::string(processor.pmu))) {
            lacking += fmt::format(" {}", processor.pmu);
            continue;
        }
        for (const EventRow& row : event_table()) {
            if ((row.generations & processor.generation) == 0) continue;
            const Expected<EventCode> code = encode_by_libpfm(full_name(processor, row));
            ASSERT_TRUE(code.value) << code.reason;
            EXPECT_EQ(code.value->type, static_cast<std::uint32_t>(PERF_TYPE_RAW));
            EXPECT_EQ(code.value->config, row.config) << full_name(processor, row);
            EXPECT_FALSE(code.value->kernel_too);
            ++checked;
        }
    }
    fmt::print("libpfm encodes {} rows of the table alike; it lacks{}\n", checked,
               lacking.empty() ? " no processor of the table" : lacking);
    // Ten x86 processors since 4.13 (2023); libpfm holds those of one architecture.
    EXPECT_GE(checked, pmus.contains("skx") ? 100u : 10u);
}

void check_wrong_names() {
    EXPECT_TRUE(encode_by_libpfm("skx::MEM_LOAD_RETIRED:L1_MISS").value);
    for (const char* name :
         {"skx::MEM_LOAD_RETIRED:L9_MISS", "skx::MEM_LOADS_RETIRED:L1_MISS",
          "nosuch::MEM_LOAD_RETIRED:L1_MISS", "amd64_fam17h_zen2::MISALIGNED_LOADS:MA64"}) {
        const Expected<EventCode> code = encode_by_libpfm(name);
        EXPECT_FALSE(code.value) << name;
        EXPECT_NE(code.reason.find(name), std::string::npos) << code.reason;
    }
    const auto other_mask = encode_by_libpfm("skx::MEM_LOAD_RETIRED:L2_MISS");
    ASSERT_TRUE(other_mask.value);
    EXPECT_NE(other_mask.value->config, find_event(Metric::l1d_load_misses, generation::skylake)->config);
}

void check_chain_of_skx() {
    Cpu cpu;
    cpu.vendor.value = "GenuineIntel";
    cpu.family.value = 6;
    cpu.model.value = 0x55;
    cpu.stepping.value = 4;
    for (const MetricName& metric : metrics) {
        const auto found = event_candidates(metric, cpu);
        ASSERT_GE(found.size(), 2u) << metric.name;
        EXPECT_EQ(found[0].by, "libpfm") << metric.name;
        EXPECT_TRUE(found[0].encoding.starts_with("skx::")) << found[0].encoding;
        EXPECT_EQ(found[1].by, "raw");
        EXPECT_EQ(found[0].code.config, found[1].code.config) << metric.name;
        EXPECT_EQ(found[0].level, found[1].level);
    }
    // Another processor's names are refused then, and its raw codes are still there.
    cpu.model.value = 0x8f;
    EXPECT_EQ(event_candidates(metrics[0], cpu).at(0).by, "raw");
}

TEST(EventEncoding, EveryRowIsWhatLibpfmSays) { with_switch("LIBPFM_ENCODE_INACTIVE", "1", check_every_row); }

TEST(EventEncoding, AWrongUnitMaskOrNameIsSeen) {
    if (!known_pmus().contains("skx")) GTEST_SKIP() << "this libpfm has no x86 processors";
    with_switch("LIBPFM_ENCODE_INACTIVE", "1", check_wrong_names);
}

TEST(EventEncoding, OnAnotherMakersServerTheChainStartsWithLibpfm) {
    if (!known_pmus().contains("skx")) GTEST_SKIP() << "this libpfm has no x86 processors";
    with_switch("LIBPFM_FORCE_PMU", "skx", check_chain_of_skx);
}

}  // namespace
}  // namespace edgewise::measure
