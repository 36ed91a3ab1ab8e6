// SPDX-License-Identifier: MIT
//
// Facts about this machine: everything that may explain a time or a miss, from the small text files in which
// Linux describes itself. Only what stays the same from run to run: no load, no free memory, no present clock
// rate.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

/// The whole file without trailing white space.
[[nodiscard]] Expected<std::string> read_text(const std::filesystem::path& file);

/// The number in a file that holds one whole number, decimal or 0x-hexadecimal, with an optional K, M or G
/// (1024 based).
[[nodiscard]] Expected<std::int64_t> read_number(const std::filesystem::path& file);

/// The number at the start of a text, as read_number reads it; null when there is none or when text follows.
[[nodiscard]] std::optional<std::int64_t> parse_number(std::string text);

/// The processor, from the text of /proc/cpuinfo. x86 and 64-bit Arm have different names there: vendor,
/// family, model and stepping are Arm's implementer, architecture, part and revision.
struct Cpu {
    Expected<std::string> vendor;  ///< "GenuineIntel", "AuthenticAMD", or Arm's implementer: "0x41"
    Expected<std::string> name;
    Expected<std::int64_t> family, model, stepping;
    Expected<std::int64_t> cores;                ///< physical ones
    std::int64_t threads = 0;                    ///< logical processors the system runs
    std::vector<std::string> vector_extensions;  ///< those that change what code can be generated or run
    Expected<bool> hypervisor;                   ///< x86 only: the flag that shows a guest that it is one
};

[[nodiscard]] Cpu parse_cpu(std::string_view cpuinfo);

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

/// Caches in the order of sysfs (level 1 first). `root` is "/" except in tests, here and below.
[[nodiscard]] Expected<std::vector<Cache>> read_caches(const std::filesystem::path& root);

[[nodiscard]] Machine read_machine(const std::filesystem::path& root = "/");

}  // namespace edgewise::measure
