// SPDX-License-Identifier: MIT
//
// The processors with known events, distinguished as libpfm does: by vendor, family, model and stepping.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "edgewise/measure/machine/cpu.hpp"

namespace edgewise::measure {

enum class CpuMaker { intel, amd, arm, other };

/// Processors that share their events' codes; a bit each, so that a set of them is a sum.
namespace generation {
inline constexpr unsigned skylake = 1;  ///< to Ice Lake
inline constexpr unsigned sapphire_rapids = 2;
inline constexpr unsigned zen2 = 4, zen3 = 8, zen4 = 16, zen5 = 32;
inline constexpr unsigned neoverse_n1 = 64, neoverse_v2 = 128;
inline constexpr unsigned k7 = 256;
}  // namespace generation

/// first .. last; of one number where no last is given.
struct NumberRange {
    std::int64_t first = -1, last = first;

    [[nodiscard]] constexpr bool holds(std::int64_t number) const {
        return first >= 0 && first <= number && number <= last;
    }
};

struct Processor {
    std::string_view pmu;  ///< libpfm's name
    std::string_view name;
    unsigned generation;  ///< one bit
    CpuMaker maker;
    std::int64_t family;    ///< Arm: the architecture, always 8
    NumberRange models[5];  ///< unused ones hold no number
    NumberRange steppings = {0, 0xffff};
};

/// All of them, each once.
[[nodiscard]] std::span<const Processor> processors();

/// Null for a processor that is not among them.
[[nodiscard]] const Processor* find_processor(const Cpu& cpu);

/// Maker of the processor, from the vendor's name in /proc/cpuinfo.
[[nodiscard]] CpuMaker maker_of(const Cpu& cpu);

}  // namespace edgewise::measure
