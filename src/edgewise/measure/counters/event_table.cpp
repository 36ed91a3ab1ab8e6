// SPDX-License-Identifier: MIT
//
// Names: libpfm 4.13 for the x86 processors it has; for Zen 5 libpfm's later tables; for Arm libpfm's names.
// AMD's L3 counters are left out: they belong to a whole core complex, not to a thread, so the last level is
// seen through the core's own fills from memory. The generic events are defined in the kernel's tables in
// arch/x86/events/intel/core.c, amd/core.c and drivers/perf/arm_pmuv3.c.
//
// Family and model numbers of processors: libpfm 4.13 (pfmlib_intel_*.c, pfmlib_amd64.c) and, for what is
// newer, the kernel's arch/x86/include/asm/intel-family.h and arch/x86/kernel/cpu/amd.c. 4.13 itself does not
// recognise some desktop models of Zen 3 and 4 (family 25, model 0x61).
#include "edgewise/measure/counters/event_table.hpp"

#include <fmt/core.h>

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

constexpr GenericEvent generic_events[] = {
    {instructions, CpuMaker::other, "INSTRUCTIONS", "instructions (retired)"},
    {cycles, CpuMaker::other, "CYCLES", own_clock},
    {branches, CpuMaker::other, "BRANCHES", "branches"},
    {branch_misses, CpuMaker::other, "BRANCH-MISSES", guessed_wrong},
    {loads, CpuMaker::intel, "L1-DCACHE-LOADS", "load instructions"},
    {stores, CpuMaker::intel, "L1-DCACHE-STORES", "store instructions"},
    {l1d_fills, CpuMaker::intel, "L1-DCACHE-LOAD-MISSES",
     "lines brought into L1D, for loads and stores (prefetches too)"},
    {l1d_fills, CpuMaker::amd, "L1-DCACHE-LOAD-MISSES",
     "requests of L1D to L2, for loads and stores (prefetches too)"},
    {l1d_fills, CpuMaker::arm, "L1-DCACHE-LOAD-MISSES",
     "lines brought into L1D, for loads and stores (prefetches too)"},
    {l2_demand_misses, CpuMaker::amd, "CACHE-MISSES",
     "requests of both first-level caches that missed L2 (prefetches too, but not L2's own)"},
    {llc_misses, CpuMaker::intel, "CACHE-MISSES",
     "requests of the core that missed the last level (prefetches too)"},
    {llc_misses, CpuMaker::arm, "LLC-LOAD-MISSES", "reads that missed the last level"},
    {dtlb_walks, CpuMaker::intel, "DTLB-LOAD-MISSES", "misses of the data TLBs, for loads"},
    {dtlb_walks, CpuMaker::amd, "DTLB-LOAD-MISSES", "misses of both data TLBs, for loads and stores"},
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

std::span<const Processor> processors() {
    using namespace generation;
    using enum CpuMaker;
    static constexpr Processor known[] = {
        // To Kaby, Coffee and Whiskey Lake (0x8e, 0x9e) and Comet Lake (0xa5).
        {"skl", "Intel Skylake", skylake, intel, 6, {{0x4e}, {0x5e}, {0x8e}, {0x9e}, {0xa5, 0xa6}}},
        {"skx", "Intel Skylake server", skylake, intel, 6, {{0x55}}, {0, 4}},
        {"clx", "Intel Cascade Lake server", skylake, intel, 6, {{0x55}}, {5, 0xf}},
        // To Tiger Lake (0x8c) and Rocket Lake (0xa7).
        {"icl", "Intel Ice Lake", skylake, intel, 6, {{0x7d, 0x7e}, {0x8c, 0x8d}, {0x9d}, {0xa7}}},
        {"icx", "Intel Ice Lake server", skylake, intel, 6, {{0x6a}, {0x6c}}},
        {"spr", "Intel Sapphire Rapids", sapphire_rapids, intel, 6, {{0x8f}, {0xcf}}},  // and Emerald Rapids
        {"amd64_fam17h_zen2", "AMD Zen 2", zen2, amd, 0x17, {{0x30, 0xff}}},
        {"amd64_fam19h_zen3", "AMD Zen 3", zen3, amd, 0x19, {{0x00, 0x0f}, {0x20, 0x5f}}},
        {"amd64_fam19h_zen4", "AMD Zen 4", zen4, amd, 0x19, {{0x10, 0x1f}, {0x60, 0xaf}}},
        {"amd64_fam1ah_zen5", "AMD Zen 5", zen5, amd, 0x1a, {{0x00, 0x2f}, {0x40, 0x4f}, {0x60, 0x7f}}},
        {"arm_n1", "Arm Neoverse N1", neoverse_n1, arm, 8, {{0xd0c}}},
        {"arm_v2", "Arm Neoverse V2", neoverse_v2, arm, 8, {{0xd4f}}},
        {"amd64_k7", "AMD K7", k7, amd, 6, {{0x00, 0xff}}},
    };
    return known;
}

const Processor* find_processor(const Cpu& cpu) {
    const std::int64_t model = cpu.model.value.value_or(-1);
    for (const Processor& processor : processors()) {
        if (processor.maker != maker_of(cpu) || processor.family != cpu.family.value.value_or(-1)) continue;
        if (!processor.steppings.holds(cpu.stepping.value.value_or(0))) continue;
        for (const NumberRange& models : processor.models) {
            if (models.holds(model)) return &processor;
        }
    }
    return nullptr;
}

CpuMaker maker_of(const Cpu& cpu) {
    const std::string vendor = cpu.vendor.value.value_or("");
    if (vendor == "GenuineIntel") return CpuMaker::intel;
    if (vendor == "AuthenticAMD" || vendor == "HygonGenuine") return CpuMaker::amd;
    if (vendor.starts_with("0x")) return CpuMaker::arm;
    return CpuMaker::other;
}

}  // namespace edgewise::measure
