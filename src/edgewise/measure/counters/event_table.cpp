// SPDX-License-Identifier: MIT
//
// Names: libpfm 4.13 for the x86 processors it has; for Zen 5 libpfm's later tables; for Arm libpfm's names.
// AMD's L3 counters are left out: they belong to a whole core complex, not to a thread, so the last level is
// seen through the core's own fills from memory. The generic events are defined in the kernel's tables in
// arch/x86/events/intel/core.c, amd/core.c and drivers/perf/arm_pmuv3.c.
#include "edgewise/measure/counters/event_table.hpp"

#include <fmt/core.h>
#include <linux/perf_event.h>

namespace edgewise::measure {

namespace {

using namespace generation;
using enum EventScope;
using enum EventTime;
using enum Metric;

constexpr unsigned intel = skylake | sapphire_rapids;
constexpr unsigned zen = zen2 | zen3 | zen4 | zen5;
constexpr unsigned zen_3_to_5 = zen3 | zen4 | zen5;
constexpr unsigned arm = neoverse_n1 | neoverse_v2;

constexpr std::string_view own_clock = "cycles of the core's own clock";
constexpr std::string_view guessed_wrong = "branches guessed wrong";
constexpr std::string_view fills = "lines brought into L1D, for loads and stores";
constexpr std::string_view fills_from_memory = "lines brought into L1D from memory, for loads and stores";

constexpr EventRow rows[] = {
    {instructions, intel, "INSTRUCTION_RETIRED", "instructions", demand, retired},
    {instructions, zen | k7, "RETIRED_INSTRUCTIONS", "instructions", demand, retired},
    {instructions, arm, "INST_RETIRED", "instructions", demand, retired},

    {cycles, intel, "UNHALTED_CORE_CYCLES", own_clock, all},
    {cycles, zen, "CYCLES_NOT_IN_HALT", own_clock, all},
    {cycles, k7, "CPU_CLK_UNHALTED", own_clock, all},
    {cycles, arm, "CPU_CYCLES", own_clock, all},

    {branches, intel, "BR_INST_RETIRED:ALL_BRANCHES", "branches of every kind", demand, retired},
    {branches, zen | k7, "RETIRED_BRANCH_INSTRUCTIONS", "branches of every kind, interrupts too", demand,
     retired},
    {branches, arm, "BR_RETIRED", "branches that a wrong guess would cost", demand, retired},

    {branch_misses, intel, "BR_MISP_RETIRED:ALL_BRANCHES", guessed_wrong, demand, retired},
    {branch_misses, zen, "RETIRED_BRANCH_INSTRUCTIONS_MISPREDICTED", guessed_wrong, demand, retired},
    {branch_misses, k7, "RETIRED_MISPREDICTED_BRANCH_INSTRUCTIONS", guessed_wrong, demand, retired},
    {branch_misses, arm, "BR_MIS_PRED_RETIRED", guessed_wrong, demand, retired},

    {loads, intel, "MEM_INST_RETIRED:ALL_LOADS", "load instructions", demand, retired},
    {loads, zen, "LS_DISPATCH:LD_DISPATCH", "load operations sent to the load-store unit"},
    {loads, arm, "MEM_ACCESS_RD", "read accesses to memory"},

    {stores, intel, "MEM_INST_RETIRED:ALL_STORES", "store instructions", demand, retired},
    {stores, zen, "LS_DISPATCH:STORE_DISPATCH", "store operations sent to the load-store unit"},
    {stores, arm, "MEM_ACCESS_WR", "write accesses to memory"},

    {l1d_fills, intel, "L1D:REPLACEMENT", fills, all},
    {l1d_fills, zen2, "REQUESTS_TO_L2_GROUP1:RD_BLK_L:RD_BLK_X:LS_RD_BLK_C_S:CHANGE_TO_X",
     "requests of L1D to L2, for loads and stores, among them those to own a line it has", all},
    {l1d_fills, zen3,
     "ANY_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:INT_CACHE:EXT_CACHE_LCL:MEM_IO_LCL:EXT_CACHE_RMT:MEM_IO_RMT",
     fills, all},
    {l1d_fills, zen4,
     "ANY_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:LOCAL_CCX:NEAR_CACHE_NEAR_FAR:DRAM_IO_NEAR:FAR_CACHE_NEAR_FAR:DRAM_IO_FAR:ALT_MEM_NEAR_FAR",
     fills, all},
    {l1d_fills, zen5,
     "ANY_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:LOCAL_CCX:NEAR_FAR_CACHE_NEAR:DRAM_IO_NEAR:NEAR_FAR_CACHE_FAR:DRAM_IO_FAR",
     fills, all},
    {l1d_fills, arm, "L1D_CACHE_REFILL", fills, all},
    {l1d_fills, k7, "DATA_CACHE_MISSES", "loads and stores that missed L1D"},

    {l1d_load_misses, intel, "MEM_LOAD_RETIRED:L1_MISS",
     "load instructions that missed L1D; one that met a line under way is not among them", demand, retired},
    {l1d_load_misses, zen2,
     "DATA_CACHE_REFILLS_FROM_SYSTEM:MABRESP_LCL_L2:LS_MABRESP_LCL_CACHE:LS_MABRESP_LCL_DRAM:LS_MABRESP_RMT_CACHE:LS_MABRESP_RMT_DRAM",
     fills},
    {l1d_load_misses, zen3,
     "DEMAND_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:INT_CACHE:EXT_CACHE_LCL:MEM_IO_LCL:EXT_CACHE_RMT:MEM_IO_RMT",
     fills},
    {l1d_load_misses, zen4,
     "DEMAND_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:LOCAL_CCX:NEAR_CACHE_NEAR_FAR:DRAM_IO_NEAR:FAR_CACHE_NEAR_FAR:DRAM_IO_FAR:ALT_MEM_NEAR_FAR",
     fills},
    {l1d_load_misses, zen5,
     "DEMAND_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:LOCAL_CCX:NEAR_FAR_CACHE_NEAR:DRAM_IO_NEAR:NEAR_FAR_CACHE_FAR:DRAM_IO_FAR",
     fills},
    {l1d_load_misses, neoverse_n1, "L1D_CACHE_REFILL_RD", "lines brought into L1D, for loads", all},
    {l1d_load_misses, neoverse_v2, "L1D_CACHE_LMISS_RD", "reads that missed L1D and had to wait"},

    {l2_demand_misses, intel, "L2_RQSTS:ALL_DEMAND_MISS",
     "loads, stores and instruction fetches that missed L2"},
    {l2_demand_misses, zen, "CORE_TO_L2_CACHEABLE_REQUEST_ACCESS_STATUS:LS_RD_BLK_C",
     "requests of L1D and its prefetcher, not of L2's, that missed L2", all},
    {l2_demand_misses, arm, "L2D_CACHE_REFILL", "lines brought into L2, for data and instructions", all},

    {llc_misses, intel, "MEM_LOAD_RETIRED:L3_MISS", "load instructions that missed the last level", demand,
     retired},
    {llc_misses, zen2, "DATA_CACHE_REFILLS_FROM_SYSTEM:LS_MABRESP_LCL_DRAM:LS_MABRESP_RMT_DRAM",
     fills_from_memory},
    {llc_misses, zen3, "DEMAND_DATA_CACHE_FILLS_FROM_SYSTEM:MEM_IO_LCL:MEM_IO_RMT", fills_from_memory},
    {llc_misses, zen4 | zen5, "DEMAND_DATA_CACHE_FILLS_FROM_SYSTEM:DRAM_IO_NEAR:DRAM_IO_FAR",
     fills_from_memory},
    {llc_misses, arm, "LL_CACHE_MISS_RD", "reads that missed the last level"},

    {dtlb_walks, skylake, "DTLB_LOAD_MISSES:WALK_COMPLETED", "page walks ended, for loads"},
    {dtlb_walks, sapphire_rapids, "DTLB_LOAD_MISSES:WALK_COMPLETED", "page walks ended, for loads"},
    {dtlb_walks, zen,
     "L1_DTLB_MISS:TLB_RELOAD_4K_L2_MISS:TLB_RELOAD_COALESCED_PAGE_MISS:TLB_RELOAD_2M_L2_MISS:TLB_RELOAD_1G_L2_MISS",
     "misses of both data TLBs, for loads and stores"},
    {dtlb_walks, arm, "DTLB_WALK", "page walks, for loads and stores"},
    {dtlb_walks, k7, "L1_DTLB_AND_L2_DTLB_MISS", "misses of both data TLBs, for loads and stores"},

    {line_crossing_loads, intel, "MEM_INST_RETIRED:SPLIT_LOADS",
     "load instructions that touch two cache lines", demand, retired},
    {line_crossing_loads, zen_3_to_5, "MISALIGNED_LOADS:MA64", "loads that touch two cache lines", demand,
     retired},
};

constexpr EventCode hardware(std::uint64_t config) { return {PERF_TYPE_HARDWARE, config}; }

constexpr EventCode cached(std::uint64_t cache, std::uint64_t result,
                           std::uint64_t operation = PERF_COUNT_HW_CACHE_OP_READ) {
    return {PERF_TYPE_HW_CACHE, cache | operation << 8 | result << 16};
}

constexpr EventCode l1d_reads = cached(PERF_COUNT_HW_CACHE_L1D, PERF_COUNT_HW_CACHE_RESULT_ACCESS);
constexpr EventCode l1d_writes =
    cached(PERF_COUNT_HW_CACHE_L1D, PERF_COUNT_HW_CACHE_RESULT_ACCESS, PERF_COUNT_HW_CACHE_OP_WRITE);
constexpr EventCode l1d_misses = cached(PERF_COUNT_HW_CACHE_L1D, PERF_COUNT_HW_CACHE_RESULT_MISS);
constexpr EventCode llc_read_misses = cached(PERF_COUNT_HW_CACHE_LL, PERF_COUNT_HW_CACHE_RESULT_MISS);
constexpr EventCode dtlb_misses = cached(PERF_COUNT_HW_CACHE_DTLB, PERF_COUNT_HW_CACHE_RESULT_MISS);

constexpr GenericEvent generic_events[] = {
    {instructions, CpuMaker::other, hardware(PERF_COUNT_HW_INSTRUCTIONS), "instructions (retired)"},
    {cycles, CpuMaker::other, hardware(PERF_COUNT_HW_CPU_CYCLES), own_clock},
    {branches, CpuMaker::other, hardware(PERF_COUNT_HW_BRANCH_INSTRUCTIONS), "branches"},
    {branch_misses, CpuMaker::other, hardware(PERF_COUNT_HW_BRANCH_MISSES), guessed_wrong},
    {loads, CpuMaker::intel, l1d_reads, "load instructions"},
    {stores, CpuMaker::intel, l1d_writes, "store instructions"},
    {l1d_fills, CpuMaker::intel, l1d_misses, "lines brought into L1D, for loads and stores (prefetches too)"},
    {l1d_fills, CpuMaker::amd, l1d_misses, "requests of L1D to L2, for loads and stores (prefetches too)"},
    {l1d_fills, CpuMaker::arm, l1d_misses, "lines brought into L1D, for loads and stores (prefetches too)"},
    {l2_demand_misses, CpuMaker::amd, hardware(PERF_COUNT_HW_CACHE_MISSES),
     "requests of both first-level caches that missed L2 (prefetches too, but not L2's own)"},
    {llc_misses, CpuMaker::intel, hardware(PERF_COUNT_HW_CACHE_MISSES),
     "requests of the core that missed the last level (prefetches too)"},
    {llc_misses, CpuMaker::arm, llc_read_misses, "reads that missed the last level"},
    {dtlb_walks, CpuMaker::intel, dtlb_misses, "misses of the data TLBs, for loads"},
    {dtlb_walks, CpuMaker::amd, dtlb_misses, "misses of both data TLBs, for loads and stores"},
};

}  // namespace

std::span<const EventRow> event_table() { return rows; }

const EventRow* find_event(Metric metric, unsigned generation) {
    for (const EventRow& row : rows) {
        if (row.metric == metric && (row.generations & generation) != 0) return &row;
    }
    return nullptr;
}

const GenericEvent* find_generic(Metric metric, CpuMaker maker) {
    for (const GenericEvent& event : generic_events) {
        if (event.metric == metric && (event.maker == CpuMaker::other || event.maker == maker)) return &event;
    }
    return nullptr;
}

std::string meaning(const EventRow& row) {
    if (row.metric == cycles) return std::string(row.counts);
    const char* const when = row.time == retired ? "retired" : "speculative ones too";
    // Prefetches are a question of what moves between caches only.
    if (row.metric < l1d_fills || row.metric == line_crossing_loads)
        return fmt::format("{} ({})", row.counts, when);
    return fmt::format("{} ({}, {})", row.counts,
                       row.scope == demand ? "without prefetches" : "prefetches too", when);
}

std::string processors_with(Metric metric) {
    std::string names;
    for (const Processor& processor : processors()) {
        if (find_event(metric, processor.generation) == nullptr) continue;
        names += fmt::format("{}{}", names.empty() ? "" : ", ", processor.name);
    }
    return names;
}

}  // namespace edgewise::measure
