// SPDX-License-Identifier: MIT
//
// The generic events name different things on different processors; `level` says which, from the kernel's
// tables (arch/x86/events/intel/core.c, amd/core.c, arm_pmuv3.c): "cache-misses" is the last level on Intel,
// the second level on AMD and the first on Arm.
//
// Departure from "user mode only": context-switches and cpu-migrations happen inside the kernel, so that the
// kernel filters every one of them out of a user-only count, which then is a perfect 0 without any error.
#include "edgewise/measure/counters.hpp"

#include <fmt/core.h>
#include <linux/perf_event.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>

#include "edgewise/measure/perf_event.hpp"

namespace edgewise {

namespace {

/// What an event counts, by maker; empty: nobody can say.
struct Levels {
    std::string_view intel, amd, arm, other;
};

struct Event {
    std::string_view name;
    EventCode code;
    Levels levels;
    bool must_happen;  ///< the reference work causes it for certain
    std::string_view unit = "1";
};

constexpr std::uint64_t read_misses(std::uint64_t cache) {
    return cache | PERF_COUNT_HW_CACHE_OP_READ << 8 | PERF_COUNT_HW_CACHE_RESULT_MISS << 16;
}

constexpr Levels core{"core", "core", "core", "core"};
constexpr Levels kernel{"kernel", "kernel", "kernel", "kernel"};
constexpr Levels generic_cache{"LLC", "L2", "L1D", ""};
constexpr Levels first_level{"L1D", "L1D", "L1D", "L1D"};
constexpr Levels translation{"dTLB, page walks", "L1 dTLB", "L1 dTLB", ""};

constexpr std::array<Event, 11> events{{
    {"instructions", {PERF_TYPE_HARDWARE, PERF_COUNT_HW_INSTRUCTIONS}, core, true},
    {"cycles", {PERF_TYPE_HARDWARE, PERF_COUNT_HW_CPU_CYCLES}, core, true},
    {"cache-references", {PERF_TYPE_HARDWARE, PERF_COUNT_HW_CACHE_REFERENCES}, generic_cache, false},
    {"cache-misses", {PERF_TYPE_HARDWARE, PERF_COUNT_HW_CACHE_MISSES}, generic_cache, false},
    {"branch-misses", {PERF_TYPE_HARDWARE, PERF_COUNT_HW_BRANCH_MISSES}, core, false},
    {"L1-dcache-load-misses", {PERF_TYPE_HW_CACHE, read_misses(PERF_COUNT_HW_CACHE_L1D)}, first_level, true},
    {"dTLB-load-misses", {PERF_TYPE_HW_CACHE, read_misses(PERF_COUNT_HW_CACHE_DTLB)}, translation, false},
    {"page-faults", {PERF_TYPE_SOFTWARE, PERF_COUNT_SW_PAGE_FAULTS}, kernel, true},
    {"context-switches", {PERF_TYPE_SOFTWARE, PERF_COUNT_SW_CONTEXT_SWITCHES, true}, kernel, true},
    {"cpu-migrations", {PERF_TYPE_SOFTWARE, PERF_COUNT_SW_CPU_MIGRATIONS, true}, kernel, false},
    {"task-clock", {PERF_TYPE_SOFTWARE, PERF_COUNT_SW_TASK_CLOCK}, kernel, true, "ns"},
}};

std::string encoding(const EventCode& code) {
    const char* const type = code.type == PERF_TYPE_HARDWARE   ? "PERF_TYPE_HARDWARE"
                             : code.type == PERF_TYPE_HW_CACHE ? "PERF_TYPE_HW_CACHE"
                                                               : "PERF_TYPE_SOFTWARE";
    return fmt::format("{}:{:#x}{}", type, code.config, code.kernel_too ? "" : ":u");
}

std::optional<std::string> level(const Levels& levels, const Cpu& cpu) {
    const std::string vendor = cpu.vendor.value.value_or("");
    const std::string_view found = vendor == "GenuineIntel"   ? levels.intel
                                   : vendor == "AuthenticAMD" ? levels.amd
                                   : vendor == "HygonGenuine" ? levels.amd
                                   : vendor.starts_with("0x") ? levels.arm
                                                              : levels.other;
    if (found.empty()) return std::nullopt;
    return std::string(found);
}

/// See reference_work. False when the system gives no memory.
bool do_reference_work() {
    const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t bytes = 256 * page;
    void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return false;
    // One page fault a page; a huge page would take them all in one. May fail where there are none.
    madvise(memory, bytes, MADV_NOHUGEPAGE);
    auto* const data = static_cast<volatile unsigned char*>(memory);
    for (std::size_t i = 0; i < bytes; i += page) data[i] = 1;
    std::size_t at = 0;
    for (std::size_t i = 0; i < 100'000; ++i) at = (at * 5 + 64 * 1021 + data[at]) % bytes;
    munmap(memory, bytes);
    const timespec nap{0, 10'000};
    nanosleep(&nap, nullptr);
    return true;
}

void set_unavailable(CounterRecord& record, std::string reason, std::string remedy) {
    record.value.reset();
    record.reason = std::move(reason);
    record.remedy = std::move(remedy);
}

void judge(CounterRecord& record, const EventCount& count, bool must_happen) {
    if (count.running_ns == 0) {
        set_unavailable(
            record, "opened, but it was never on a counter",
            "on a hybrid processor pin the thread to a core whose counters the event is for (taskset); "
            "else end other users of the counters");
    } else if (count.running_ns < count.enabled_ns) {
        set_unavailable(
            record,
            fmt::format("on a counter for only {} of {} ns: it shared one, and a scaled count is a guess",
                        count.running_ns, count.enabled_ns),
            "end other users of the counters, also the NMI watchdog (sysctl kernel.nmi_watchdog=0)");
    } else if (count.value == 0 && must_happen) {
        set_unavailable(record, "counted 0 over work that must cause it: this counter does not work here",
                        "run outside the virtual machine or container");
    } else {
        record.value = count.value;
    }
}

CounterRecord read_counter(const Event& event, const Cpu& cpu) {
    CounterRecord record;
    record.event = event.name;
    record.encoding = encoding(event.code);
    record.level = level(event.levels, cpu);
    record.unit = event.unit;
    PerfEvent counter(event.code);
    if (counter.error() != 0) {
        record.error = counter.error();
        explain_error(record, event.code.type != PERF_TYPE_SOFTWARE, cpu);
        return record;
    }
    const bool worked = counter.start() && do_reference_work();
    const std::optional<EventCount> count = counter.stop();
    if (worked && count) {
        judge(record, *count, event.must_happen);
    } else {
        set_unavailable(record, "opened, but the kernel gave no count", "try again");
    }
    return record;
}

}  // namespace

void explain_error(CounterRecord& record, bool hardware, const Cpu& cpu) {
    const bool guest = cpu.hypervisor.value.value_or(false);
    const std::string words = std::strerror(record.error);
    const auto is_one_of = [&](auto... codes) { return ((record.error == codes) || ...); };
    if (is_one_of(EACCES, EPERM)) {
        set_unavailable(record, "no permission: " + words,
                        "as root: sysctl kernel.perf_event_paranoid=1, or give the program CAP_PERFMON; "
                        "in a container also allow perf_event_open in its seccomp profile");
    } else if (is_one_of(ENOENT, EOPNOTSUPP, ENODEV) && hardware && guest) {
        set_unavailable(
            record, "this virtual machine has no performance counters for it: " + words,
            "have the hypervisor pass the PMU through (KVM: -cpu host,pmu=on), or run on the bare machine");
    } else if (is_one_of(ENOENT, EOPNOTSUPP, ENODEV, EINVAL)) {
        set_unavailable(record, "this processor or kernel does not have the event: " + words,
                        "use a kernel that knows the processor, or an event by its raw code");
    } else if (record.error == ENOSYS) {
        set_unavailable(
            record, "the kernel has no perf_event_open: " + words,
            "use a kernel with CONFIG_PERF_EVENTS, outside of a sandbox that emulates system calls");
    } else if (is_one_of(EBUSY, EMFILE, ENOSPC)) {
        set_unavailable(record, "no counter or file descriptor free: " + words,
                        "end other users of the counters, or raise ulimit -n");
    } else {
        set_unavailable(record, words, "see man 2 perf_event_open");
    }
}

std::vector<CounterRecord> read_counters(const Cpu& cpu) {
    std::vector<CounterRecord> records;
    for (const Event& event : events) records.push_back(read_counter(event, cpu));
    return records;
}

}  // namespace edgewise
