// SPDX-License-Identifier: MIT
//
// Names and codes: libpfm 4.13 for the x86 processors it has (a unit test encodes each row again with the
// libpfm of the build); for Zen 5 libpfm's later tables and the Linux kernel's
// tools/perf/pmu-events/arch/x86/amdzen5; for Arm the architected codes (Arm ARM, D13.12) under libpfm's
// names. AMD's L3 counters are left out: they belong to a whole core complex, not to a thread, so the last
// level is seen through the core's own fills from memory.
#include "edgewise/measure/counters/event_table.hpp"

#include <fmt/core.h>

#include <array>

namespace edgewise::measure {

namespace {

using enum EventScope;
using enum EventTime;
using enum Metric;

constexpr unsigned intel = generation::skylake | generation::sapphire_rapids;
constexpr unsigned zen = generation::zen2 | generation::zen3 | generation::zen4 | generation::zen5;
constexpr unsigned zen_3_to_5 = generation::zen3 | generation::zen4 | generation::zen5;
constexpr unsigned arm = generation::neoverse_n1 | generation::neoverse_v2;

constexpr std::string_view own_clock = "cycles of the core's own clock";
constexpr std::string_view guessed_wrong = "branches guessed wrong";
constexpr std::string_view fills = "lines brought into L1D, for loads and stores";
constexpr std::string_view fills_from_memory = "lines brought into L1D from memory, for loads and stores";
constexpr std::string_view walks = "dTLB, page walks";

constexpr auto rows = std::to_array<EventRow>({
    {instructions, intel, "INSTRUCTION_RETIRED", 0xc0, "core", "instructions", demand, retired},
    {instructions, zen | generation::k7, "RETIRED_INSTRUCTIONS", 0xc0, "core", "instructions", demand,
     retired},
    {instructions, arm, "INST_RETIRED", 0x08, "core", "instructions", demand, retired},

    {cycles, intel, "UNHALTED_CORE_CYCLES", 0x3c, "core", own_clock, all, speculative},
    {cycles, zen, "CYCLES_NOT_IN_HALT", 0x76, "core", own_clock, all, speculative},
    {cycles, generation::k7, "CPU_CLK_UNHALTED", 0x76, "core", own_clock, all, speculative},
    {cycles, arm, "CPU_CYCLES", 0x11, "core", own_clock, all, speculative},

    {branches, intel, "BR_INST_RETIRED:ALL_BRANCHES", 0xc4, "core", "branches of every kind", demand,
     retired},
    {branches, zen | generation::k7, "RETIRED_BRANCH_INSTRUCTIONS", 0xc2, "core",
     "branches of every kind, interrupts too", demand, retired},
    {branches, arm, "BR_RETIRED", 0x21, "core", "branches that a wrong guess would cost", demand, retired},

    {branch_misses, intel, "BR_MISP_RETIRED:ALL_BRANCHES", 0xc5, "core", guessed_wrong, demand, retired},
    {branch_misses, zen, "RETIRED_BRANCH_INSTRUCTIONS_MISPREDICTED", 0xc3, "core", guessed_wrong, demand,
     retired},
    {branch_misses, generation::k7, "RETIRED_MISPREDICTED_BRANCH_INSTRUCTIONS", 0xc3, "core", guessed_wrong,
     demand, retired},
    {branch_misses, arm, "BR_MIS_PRED_RETIRED", 0x22, "core", guessed_wrong, demand, retired},

    {loads, intel, "MEM_INST_RETIRED:ALL_LOADS", 0x81d0, "core", "load instructions", demand, retired},
    {loads, zen, "LS_DISPATCH:LD_DISPATCH", 0x129, "core", "load operations sent to the load-store unit",
     demand, speculative},
    {loads, arm, "MEM_ACCESS_RD", 0x66, "core", "read accesses to memory", demand, speculative},

    {stores, intel, "MEM_INST_RETIRED:ALL_STORES", 0x82d0, "core", "store instructions", demand, retired},
    {stores, zen, "LS_DISPATCH:STORE_DISPATCH", 0x229, "core", "store operations sent to the load-store unit",
     demand, speculative},
    {stores, arm, "MEM_ACCESS_WR", 0x67, "core", "write accesses to memory", demand, speculative},

    {l1d_fills, intel, "L1D:REPLACEMENT", 0x151, "L1D", fills, all, speculative},
    {l1d_fills, generation::zen2, "REQUESTS_TO_L2_GROUP1:RD_BLK_L:RD_BLK_X:LS_RD_BLK_C_S:CHANGE_TO_X", 0xe860,
     "L1D", "requests of L1D to L2, for loads and stores, among them those to own a line it has", all,
     speculative},
    {l1d_fills, generation::zen3,
     "ANY_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:INT_CACHE:EXT_CACHE_LCL:MEM_IO_LCL:EXT_CACHE_RMT:MEM_IO_RMT",
     0x5f44, "L1D", fills, all, speculative},
    {l1d_fills, generation::zen4,
     "ANY_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:LOCAL_CCX:NEAR_CACHE_NEAR_FAR:DRAM_IO_NEAR:FAR_CACHE_NEAR_FAR:"
     "DRAM_IO_FAR:ALT_MEM_NEAR_FAR",
     0xdf44, "L1D", fills, all, speculative},
    {l1d_fills, generation::zen5,
     "ANY_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:LOCAL_CCX:NEAR_FAR_CACHE_NEAR:DRAM_IO_NEAR:NEAR_FAR_CACHE_FAR:"
     "DRAM_IO_FAR",
     0x5f44, "L1D", fills, all, speculative},
    {l1d_fills, arm, "L1D_CACHE_REFILL", 0x03, "L1D", fills, all, speculative},
    {l1d_fills, generation::k7, "DATA_CACHE_MISSES", 0x41, "L1D", "loads and stores that missed L1D", demand,
     speculative},

    {l1d_load_misses, intel, "MEM_LOAD_RETIRED:L1_MISS", 0x8d1, "L1D",
     "load instructions that missed L1D; one that met a line under way is not among them", demand, retired},
    {l1d_load_misses, generation::zen2,
     "DATA_CACHE_REFILLS_FROM_SYSTEM:MABRESP_LCL_L2:LS_MABRESP_LCL_CACHE:LS_MABRESP_LCL_DRAM:LS_MABRESP_RMT_"
     "CACHE:LS_MABRESP_RMT_DRAM",
     0x5b43, "L1D", fills, demand, speculative},
    {l1d_load_misses, generation::zen3,
     "DEMAND_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:INT_CACHE:EXT_CACHE_LCL:MEM_IO_LCL:EXT_CACHE_RMT:MEM_IO_RMT",
     0x5f43, "L1D", fills, demand, speculative},
    {l1d_load_misses, generation::zen4,
     "DEMAND_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:LOCAL_CCX:NEAR_CACHE_NEAR_FAR:DRAM_IO_NEAR:FAR_CACHE_NEAR_"
     "FAR:DRAM_IO_FAR:ALT_MEM_NEAR_FAR",
     0xdf43, "L1D", fills, demand, speculative},
    {l1d_load_misses, generation::zen5,
     "DEMAND_DATA_CACHE_FILLS_FROM_SYSTEM:LCL_L2:LOCAL_CCX:NEAR_FAR_CACHE_NEAR:DRAM_IO_NEAR:NEAR_FAR_CACHE_"
     "FAR:DRAM_IO_FAR",
     0x5f43, "L1D", fills, demand, speculative},
    {l1d_load_misses, generation::neoverse_n1, "L1D_CACHE_REFILL_RD", 0x42, "L1D",
     "lines brought into L1D, for loads", all, speculative},
    {l1d_load_misses, generation::neoverse_v2, "L1D_CACHE_LMISS_RD", 0x39, "L1D",
     "reads that missed L1D and had to wait", demand, speculative},

    {l2_demand_misses, intel, "L2_RQSTS:ALL_DEMAND_MISS", 0x2724, "L2",
     "loads, stores and instruction fetches that missed L2", demand, speculative},
    {l2_demand_misses, zen, "CORE_TO_L2_CACHEABLE_REQUEST_ACCESS_STATUS:LS_RD_BLK_C", 0x864, "L2",
     "requests of L1D and its prefetcher, not of L2's, that missed L2", all, speculative},
    {l2_demand_misses, arm, "L2D_CACHE_REFILL", 0x17, "L2",
     "lines brought into L2, for data and instructions", all, speculative},

    {llc_misses, intel, "MEM_LOAD_RETIRED:L3_MISS", 0x20d1, "LLC",
     "load instructions that missed the last level", demand, retired},
    {llc_misses, generation::zen2, "DATA_CACHE_REFILLS_FROM_SYSTEM:LS_MABRESP_LCL_DRAM:LS_MABRESP_RMT_DRAM",
     0x4843, "LLC", fills_from_memory, demand, speculative},
    {llc_misses, generation::zen3, "DEMAND_DATA_CACHE_FILLS_FROM_SYSTEM:MEM_IO_LCL:MEM_IO_RMT", 0x4843, "LLC",
     fills_from_memory, demand, speculative},
    {llc_misses, generation::zen4 | generation::zen5,
     "DEMAND_DATA_CACHE_FILLS_FROM_SYSTEM:DRAM_IO_NEAR:DRAM_IO_FAR", 0x4843, "LLC", fills_from_memory, demand,
     speculative},
    {llc_misses, arm, "LL_CACHE_MISS_RD", 0x37, "LLC", "reads that missed the last level", demand,
     speculative},

    {dtlb_walks, generation::skylake, "DTLB_LOAD_MISSES:WALK_COMPLETED", 0xe08, walks,
     "page walks ended, for loads", demand, speculative},
    {dtlb_walks, generation::sapphire_rapids, "DTLB_LOAD_MISSES:WALK_COMPLETED", 0xe12, walks,
     "page walks ended, for loads", demand, speculative},
    {dtlb_walks, zen,
     "L1_DTLB_MISS:TLB_RELOAD_4K_L2_MISS:TLB_RELOAD_COALESCED_PAGE_MISS:TLB_RELOAD_2M_L2_MISS:TLB_RELOAD_1G_"
     "L2_MISS",
     0xf045, walks, "misses of both data TLBs, for loads and stores", demand, speculative},
    {dtlb_walks, arm, "DTLB_WALK", 0x34, walks, "page walks, for loads and stores", demand, speculative},
    {dtlb_walks, generation::k7, "L1_DTLB_AND_L2_DTLB_MISS", 0x46, walks,
     "misses of both data TLBs, for loads and stores", demand, speculative},

    {line_crossing_loads, intel, "MEM_INST_RETIRED:SPLIT_LOADS", 0x41d0, "L1D",
     "load instructions that touch two cache lines", demand, retired},
    {line_crossing_loads, zen_3_to_5, "MISALIGNED_LOADS:MA64", 0x147, "L1D",
     "loads that touch two cache lines", demand, retired},
});

}  // namespace

std::span<const EventRow> event_table() { return rows; }

const EventRow* find_event(Metric metric, unsigned generation) {
    for (const EventRow& row : rows) {
        if (row.metric == metric && (row.generations & generation) != 0) return &row;
    }
    return nullptr;
}

std::string meaning(const EventRow& row) {
    if (row.metric == Metric::cycles) return std::string(row.counts);
    const char* const when = row.time == retired ? "retired" : "speculative ones too";
    // Prefetches are a question of what moves between caches only.
    if (row.level == "core" || row.metric == Metric::line_crossing_loads) {
        return fmt::format("{} ({})", row.counts, when);
    }
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
