// SPDX-License-Identifier: MIT
//
// Reads /proc and /sys (Documentation/admin-guide of the Linux kernel) and asks two system calls.
#include "edgewise/measure/machine/machine.hpp"

#include <fmt/core.h>
#include <sys/personality.h>
#include <unistd.h>

#include <sstream>

namespace edgewise::measure {

namespace {

Cpu read_cpu(const std::filesystem::path& root) {
    const Expected<std::string> text = read_text(root / "proc/cpuinfo");
    Cpu cpu = parse_cpu(text.value.value_or(""));
    if (!text.value) {
        for (Expected<std::string>* fact : {&cpu.vendor, &cpu.name}) fact->reason = text.reason;
        for (Expected<std::int64_t>* fact : {&cpu.family, &cpu.model, &cpu.stepping, &cpu.cores}) {
            fact->reason = text.reason;
        }
        cpu.hypervisor.reason = text.reason;
    }
    return cpu;
}

Expected<std::int64_t> read_memory(const std::filesystem::path& root) {
    const Expected<std::string> text = read_text(root / "proc/meminfo");
    if (!text.value) return text.refusal();
    std::istringstream lines(*text.value);
    std::string key;
    std::int64_t kibibytes = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        if (words >> key >> kibibytes && key == "MemTotal:") return {kibibytes * 1024};
    }
    return Refusal{"/proc/meminfo has no MemTotal"};
}

/// Intel's own driver has a switch for "no turbo", the others one for "boost".
Expected<bool> read_turbo(const std::filesystem::path& root) {
    const Expected<std::int64_t> off = read_number(root / "sys/devices/system/cpu/intel_pstate/no_turbo");
    if (off.value) return {*off.value == 0};
    const Expected<std::int64_t> boost = read_number(root / "sys/devices/system/cpu/cpufreq/boost");
    if (boost.value) return {*boost.value != 0};
    return Refusal{fmt::format("{}; {}", off.reason, boost.reason)};
}

/// The choice in brackets: "always [madvise] never".
Expected<std::string> read_choice(const std::filesystem::path& file) {
    const Expected<std::string> text = read_text(file);
    if (!text.value) return text;
    const auto open = text.value->find('[');
    const auto close = text.value->find(']');
    if (open == std::string::npos || close == std::string::npos || close < open)
        return Refusal{fmt::format("{}: no choice in brackets: {}", file.string(), *text.value)};
    return {text.value->substr(open + 1, close - open - 1)};
}

Expected<bool> read_own_aslr() {
    const int flags = personality(0xffffffff);  // asks, changes nothing
    if (flags < 0) return Refusal{"personality() is not allowed here"};
    return {(flags & ADDR_NO_RANDOMIZE) == 0};
}

Cache read_cache(const std::filesystem::path& index) {
    Cache cache;
    cache.level = read_number(index / "level");
    cache.type = read_text(index / "type");
    cache.bytes = read_number(index / "size");
    cache.ways = read_number(index / "ways_of_associativity");
    cache.line_bytes = read_number(index / "coherency_line_size");
    cache.sets = read_number(index / "number_of_sets");
    cache.shared_cpus = read_text(index / "shared_cpu_list");
    // The kernel writes 0 where it does not know (Arm without firmware tables): that is not a number of ways.
    for (Expected<std::int64_t>* number : {&cache.bytes, &cache.ways, &cache.line_bytes, &cache.sets}) {
        if (number->value == 0) *number = Refusal{"the kernel says 0: it does not know"};
    }
    return cache;
}

}  // namespace

Expected<std::vector<Cache>> read_caches(const std::filesystem::path& root) {
    const std::filesystem::path directory = root / "sys/devices/system/cpu/cpu0/cache";
    std::vector<Cache> caches;
    std::error_code error;
    const auto index = [&] { return directory / fmt::format("index{}", caches.size()); };
    while (std::filesystem::is_directory(index(), error)) caches.push_back(read_cache(index()));
    if (caches.empty()) return Refusal{fmt::format("{}: no caches described", directory.string())};
    return {std::move(caches)};
}

Machine read_machine(const std::filesystem::path& root) {
    Machine machine;
    machine.cpu = read_cpu(root);
    machine.caches = read_caches(root);
    machine.page_bytes = {sysconf(_SC_PAGESIZE)};
    machine.memory_bytes = read_memory(root);
    machine.kernel = read_text(root / "proc/sys/kernel/osrelease");
    machine.clock_source =
        read_text(root / "sys/devices/system/clocksource/clocksource0/current_clocksource");
    machine.governor = read_text(root / "sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
    machine.turbo = read_turbo(root);
    machine.aslr = read_number(root / "proc/sys/kernel/randomize_va_space");
    machine.aslr_this_process = read_own_aslr();
    machine.transparent_huge_pages = read_choice(root / "sys/kernel/mm/transparent_hugepage/enabled");
    machine.perf_event_paranoid = read_number(root / "proc/sys/kernel/perf_event_paranoid");
    return machine;
}

}  // namespace edgewise::measure
