// SPDX-License-Identifier: MIT
//
// What the generic events are: the kernel's tables in arch/x86/events/intel/core.c, amd/core.c and
// drivers/perf/arm_pmuv3.c.
#include "edgewise/measure/counters/generic_event.hpp"

#include <linux/perf_event.h>

#include <array>
#include <cstdint>

namespace edgewise::measure {

namespace {

constexpr EventCode hardware(std::uint64_t config) { return {PERF_TYPE_HARDWARE, config}; }

constexpr EventCode cache(std::uint64_t which, std::uint64_t operation, std::uint64_t result) {
    return {PERF_TYPE_HW_CACHE, which | operation << 8 | result << 16};
}

constexpr EventCode l1d_loads =
    cache(PERF_COUNT_HW_CACHE_L1D, PERF_COUNT_HW_CACHE_OP_READ, PERF_COUNT_HW_CACHE_RESULT_ACCESS);
constexpr EventCode l1d_stores =
    cache(PERF_COUNT_HW_CACHE_L1D, PERF_COUNT_HW_CACHE_OP_WRITE, PERF_COUNT_HW_CACHE_RESULT_ACCESS);
constexpr EventCode l1d_load_misses =
    cache(PERF_COUNT_HW_CACHE_L1D, PERF_COUNT_HW_CACHE_OP_READ, PERF_COUNT_HW_CACHE_RESULT_MISS);
constexpr EventCode llc_load_misses =
    cache(PERF_COUNT_HW_CACHE_LL, PERF_COUNT_HW_CACHE_OP_READ, PERF_COUNT_HW_CACHE_RESULT_MISS);
constexpr EventCode dtlb_load_misses =
    cache(PERF_COUNT_HW_CACHE_DTLB, PERF_COUNT_HW_CACHE_OP_READ, PERF_COUNT_HW_CACHE_RESULT_MISS);

constexpr std::array<GenericEvent, 14> events{{
    {Metric::instructions, CpuMaker::other, hardware(PERF_COUNT_HW_INSTRUCTIONS), "core",
     "instructions (retired)"},
    {Metric::cycles, CpuMaker::other, hardware(PERF_COUNT_HW_CPU_CYCLES), "core",
     "cycles of the core's own clock"},
    {Metric::branches, CpuMaker::other, hardware(PERF_COUNT_HW_BRANCH_INSTRUCTIONS), "core", "branches"},
    {Metric::branch_misses, CpuMaker::other, hardware(PERF_COUNT_HW_BRANCH_MISSES), "core",
     "branches guessed wrong"},
    {Metric::loads, CpuMaker::intel, l1d_loads, "core", "load instructions"},
    {Metric::stores, CpuMaker::intel, l1d_stores, "core", "store instructions"},
    {Metric::l1d_fills, CpuMaker::intel, l1d_load_misses, "L1D",
     "lines brought into L1D, for loads and stores (prefetches too)"},
    {Metric::l1d_fills, CpuMaker::amd, l1d_load_misses, "L1D",
     "requests of L1D to L2, for loads and stores (prefetches too)"},
    {Metric::l1d_fills, CpuMaker::arm, l1d_load_misses, "L1D",
     "lines brought into L1D, for loads and stores (prefetches too)"},
    {Metric::l2_demand_misses, CpuMaker::amd, hardware(PERF_COUNT_HW_CACHE_MISSES), "L2",
     "requests of both first-level caches that missed L2 (prefetches too, but not L2's own)"},
    {Metric::llc_misses, CpuMaker::intel, hardware(PERF_COUNT_HW_CACHE_MISSES), "LLC",
     "requests of the core that missed the last level (prefetches too)"},
    {Metric::llc_misses, CpuMaker::arm, llc_load_misses, "LLC", "reads that missed the last level"},
    {Metric::dtlb_walks, CpuMaker::intel, dtlb_load_misses, "dTLB, page walks",
     "misses of the data TLBs, for loads"},
    {Metric::dtlb_walks, CpuMaker::amd, dtlb_load_misses, "dTLB, page walks",
     "misses of both data TLBs, for loads and stores"},
}};

}  // namespace

const GenericEvent* find_generic(Metric metric, CpuMaker maker) {
    for (const GenericEvent& event : events) {
        if (event.metric == metric && (event.maker == CpuMaker::other || event.maker == maker)) return &event;
    }
    return nullptr;
}

}  // namespace edgewise::measure
