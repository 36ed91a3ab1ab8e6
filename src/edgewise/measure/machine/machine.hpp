// SPDX-License-Identifier: MIT
//
// Facts about this machine: everything that may explain a time or a miss, from the small text files in which
// Linux describes itself. Only what stays the same from run to run: no load, no free memory, no present clock
// rate.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
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

/// Returns the facts of one logical processor; of the first one in the text if the text lacks its number.
[[nodiscard]] Cpu parse_cpu(std::string_view cpuinfo, std::int64_t processor = 0);

/// A cache of one processor, as the kernel reports it in sysfs (Documentation/ABI/testing/
/// sysfs-devices-system-cpu). In a virtual machine the hypervisor chooses what is reported.
struct Cache {
    Expected<std::int64_t> level, bytes, ways, line_bytes, sets;
    Expected<std::string> type;         ///< Data, Instruction or Unified
    Expected<std::string> shared_cpus;  ///< logical processors that share it, e.g. "0-7"
};

/// Logical processors with equal caches. A hybrid machine has several kinds.
struct CoreKind {
    std::vector<std::int64_t> processors;          ///< in ascending order
    std::vector<std::int64_t> allowed;             ///< those of them on which this process may run
    std::vector<Cache> caches;                     ///< of the first, in the order of sysfs (level 1 first)
    std::vector<std::set<std::string>> shared_by;  ///< of each cache: a list of processors for each copy
};

struct Machine {
    Cpu cpu;                                ///< of the first kind of cores
    Expected<std::vector<CoreKind>> cores;  ///< as read_cores returns them
    Expected<std::int64_t> page_bytes, memory_bytes;
    Expected<std::string> kernel;
    Expected<std::string> clock_source;            ///< "tsc" is cheap to read, "hpet" or "acpi_pm" are not
    Expected<std::string> governor;                ///< of the clock of the first kind's first processor
    Expected<bool> turbo;                          ///< may the clock exceed the nominal rate
    Expected<std::int64_t> aslr;                   ///< the system's: 0 off, 1 without the heap, 2 all
    Expected<bool> aslr_this_process;              ///< false under `setarch -R` and some debuggers
    Expected<std::string> transparent_huge_pages;  ///< always, madvise or never
    Expected<std::int64_t> perf_event_paranoid;
};

/// Logical processors on which this thread may run (taskset), in ascending order; empty if that is not known.
[[nodiscard]] std::vector<std::int64_t> allowed_processors();

/// Processors as taskset takes them: "0-3,8".
[[nodiscard]] std::string processor_list(std::span<const std::int64_t> processors);

/// The kinds of cores: first the kind of the first allowed processor, whose caches `host` has, then the
/// others by their first processors. `root` is "/" except in tests, here and below.
[[nodiscard]] Expected<std::vector<CoreKind>> read_cores(
    const std::filesystem::path& root = "/", std::span<const std::int64_t> allowed = allowed_processors());

/// One line: how to bind a measurement to cores of one kind.
[[nodiscard]] std::string binding_advice(std::span<const CoreKind> kinds);

[[nodiscard]] Machine read_machine(const std::filesystem::path& root = "/");

}  // namespace edgewise::measure
