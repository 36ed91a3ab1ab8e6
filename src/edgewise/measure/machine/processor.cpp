// SPDX-License-Identifier: MIT
//
// Family and model numbers: libpfm 4.13 (pfmlib_intel_*.c, pfmlib_amd64.c) and, for what is newer, the Linux
// kernel's arch/x86/include/asm/intel-family.h and arch/x86/kernel/cpu/amd.c. 4.13 itself does not recognise
// some desktop models of Zen 3 and 4 (family 25, model 0x61), which then are counted by their raw codes.
#include "edgewise/measure/machine/processor.hpp"

#include <array>

namespace edgewise::measure {

namespace {

constexpr std::array<Processor, 13> known{{
    {"skl", "Intel Skylake", generation::skylake},
    {"skx", "Intel Skylake server", generation::skylake},
    {"clx", "Intel Cascade Lake server", generation::skylake},
    {"icl", "Intel Ice Lake", generation::skylake},
    {"icx", "Intel Ice Lake server", generation::skylake},
    {"spr", "Intel Sapphire Rapids", generation::sapphire_rapids},
    {"amd64_fam17h_zen2", "AMD Zen 2", generation::zen2},
    {"amd64_fam19h_zen3", "AMD Zen 3", generation::zen3},
    {"amd64_fam19h_zen4", "AMD Zen 4", generation::zen4},
    {"amd64_fam1ah_zen5", "AMD Zen 5", generation::zen5},
    {"arm_n1", "Arm Neoverse N1", generation::neoverse_n1},
    {"arm_v2", "Arm Neoverse V2", generation::neoverse_v2},
    {"amd64_k7", "AMD K7", generation::k7},
}};

struct Range {
    std::string_view pmu;
    CpuMaker maker;
    std::int64_t family;  ///< Arm: the architecture, always 8
    std::int64_t first_model, last_model;
    std::int64_t first_stepping = 0, last_stepping = 0xffff;
};

constexpr std::array<Range, 26> ranges{{
    {"skl", CpuMaker::intel, 6, 0x4e, 0x4e},
    {"skl", CpuMaker::intel, 6, 0x5e, 0x5e},
    {"skl", CpuMaker::intel, 6, 0x8e, 0x8e},  // Kaby, Coffee and Whiskey Lake
    {"skl", CpuMaker::intel, 6, 0x9e, 0x9e},
    {"skl", CpuMaker::intel, 6, 0xa5, 0xa6},  // Comet Lake
    {"skx", CpuMaker::intel, 6, 0x55, 0x55, 0, 4},
    {"clx", CpuMaker::intel, 6, 0x55, 0x55, 5, 0xf},
    {"icl", CpuMaker::intel, 6, 0x7d, 0x7e},
    {"icl", CpuMaker::intel, 6, 0x8c, 0x8d},  // Tiger Lake
    {"icl", CpuMaker::intel, 6, 0x9d, 0x9d},
    {"icl", CpuMaker::intel, 6, 0xa7, 0xa7},  // Rocket Lake
    {"icx", CpuMaker::intel, 6, 0x6a, 0x6a},
    {"icx", CpuMaker::intel, 6, 0x6c, 0x6c},
    {"spr", CpuMaker::intel, 6, 0x8f, 0x8f},
    {"spr", CpuMaker::intel, 6, 0xcf, 0xcf},  // Emerald Rapids
    {"amd64_fam17h_zen2", CpuMaker::amd, 0x17, 0x30, 0xff},
    {"amd64_fam19h_zen3", CpuMaker::amd, 0x19, 0x00, 0x0f},
    {"amd64_fam19h_zen3", CpuMaker::amd, 0x19, 0x20, 0x5f},
    {"amd64_fam19h_zen4", CpuMaker::amd, 0x19, 0x10, 0x1f},
    {"amd64_fam19h_zen4", CpuMaker::amd, 0x19, 0x60, 0xaf},
    {"amd64_fam1ah_zen5", CpuMaker::amd, 0x1a, 0x00, 0x2f},
    {"amd64_fam1ah_zen5", CpuMaker::amd, 0x1a, 0x40, 0x4f},
    {"amd64_fam1ah_zen5", CpuMaker::amd, 0x1a, 0x60, 0x7f},
    {"amd64_k7", CpuMaker::amd, 6, 0x00, 0xff},
    {"arm_n1", CpuMaker::arm, 8, 0xd0c, 0xd0c},
    {"arm_v2", CpuMaker::arm, 8, 0xd4f, 0xd4f},
}};

bool holds(const Range& range, const Cpu& cpu) {
    const std::int64_t model = cpu.model.value.value_or(-1);
    const std::int64_t stepping = cpu.stepping.value.value_or(0);
    return range.maker == maker_of(cpu) && range.family == cpu.family.value.value_or(-1) &&
           range.first_model <= model && model <= range.last_model && range.first_stepping <= stepping &&
           stepping <= range.last_stepping;
}

}  // namespace

std::span<const Processor> processors() { return known; }

const Processor* find_processor(const Cpu& cpu) {
    for (const Range& range : ranges) {
        if (!holds(range, cpu)) continue;
        for (const Processor& processor : known) {
            if (processor.pmu == range.pmu) return &processor;
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
