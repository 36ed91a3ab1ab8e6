// SPDX-License-Identifier: MIT
//
// What this machine is: everything about it that may explain a time or a miss. Only what stays the same from
// run to run: no load, no free memory, no present clock rate.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "edgewise/measure/cache/caches.hpp"
#include "edgewise/measure/machine/cpu.hpp"
#include "edgewise/measure/machine/fact.hpp"

namespace edgewise::measure {

struct Machine {
    Cpu cpu;
    Fact<std::vector<Cache>> caches;
    Fact<std::int64_t> page_bytes, memory_bytes;
    Fact<std::string> kernel;
    Fact<std::string> clock_source;            ///< "tsc" is cheap to read, "hpet" or "acpi_pm" are not
    Fact<std::string> governor;                ///< of the first processor's clock
    Fact<bool> turbo;                          ///< may the clock exceed the nominal rate
    Fact<std::int64_t> aslr;                   ///< the system's: 0 off, 1 without the heap, 2 all
    Fact<bool> aslr_this_process;              ///< false under `setarch -R` and some debuggers
    Fact<std::string> transparent_huge_pages;  ///< always, madvise or never
    Fact<std::int64_t> perf_event_paranoid;
};

/// `root` is "/" except in tests.
[[nodiscard]] Machine read_machine(const std::filesystem::path& root = "/");

}  // namespace edgewise::measure
