// SPDX-License-Identifier: MIT
//
// Family and model numbers: libpfm 4.13 (pfmlib_intel_*.c, pfmlib_amd64.c) and, for what is newer, the Linux
// kernel's arch/x86/include/asm/intel-family.h and arch/x86/kernel/cpu/amd.c. 4.13 itself does not recognise
// some desktop models of Zen 3 and 4 (family 25, model 0x61).
#include "edgewise/measure/machine/processor.hpp"

namespace edgewise::measure {

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
