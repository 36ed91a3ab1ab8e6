// SPDX-License-Identifier: MIT
//
// Facts about this machine: everything that may explain a time or a miss. Only what stays the same from
// run to run: no load, no free memory, no present clock rate.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "edgewise/measure/machine/cpu.hpp"

namespace edgewise::measure {

/// A cache of the first processor, as the kernel reports it in sysfs (Documentation/ABI/testing/
/// sysfs-devices-system-cpu). In a virtual machine the hypervisor chooses what is reported.
struct Cache {
    Expected<std::int64_t> level, bytes, ways, line_bytes, sets;
    Expected<std::string> type;         ///< Data, Instruction or Unified
    Expected<std::string> shared_cpus;  ///< logical processors that share it, e.g. "0-7"
};

struct Machine {
    Cpu cpu;
    Expected<std::vector<Cache>> caches;
    Expected<std::int64_t> page_bytes, memory_bytes;
    Expected<std::string> kernel;
    Expected<std::string> clock_source;            ///< "tsc" is cheap to read, "hpet" or "acpi_pm" are not
    Expected<std::string> governor;                ///< of the first processor's clock
    Expected<bool> turbo;                          ///< may the clock exceed the nominal rate
    Expected<std::int64_t> aslr;                   ///< the system's: 0 off, 1 without the heap, 2 all
    Expected<bool> aslr_this_process;              ///< false under `setarch -R` and some debuggers
    Expected<std::string> transparent_huge_pages;  ///< always, madvise or never
    Expected<std::int64_t> perf_event_paranoid;
};

/// In the order of sysfs (level 1 first). `root` is "/" except in tests, here and below.
[[nodiscard]] Expected<std::vector<Cache>> read_caches(const std::filesystem::path& root);

[[nodiscard]] Machine read_machine(const std::filesystem::path& root = "/");

}  // namespace edgewise::measure
