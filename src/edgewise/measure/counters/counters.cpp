// SPDX-License-Identifier: MIT
#include "edgewise/measure/counters/counters.hpp"

#include <linux/perf_event.h>
#include <sys/mman.h>
#include <unistd.h>

#include <ctime>
#include <span>

#include "edgewise/measure/counters/counter_group.hpp"

namespace edgewise::measure {

namespace {

struct SoftwareEvent {
    std::string_view name;
    std::uint64_t config;
    bool must_happen;  ///< the reference work causes it for certain
    std::string_view meaning;
    std::string_view unit = "1";
};

constexpr SoftwareEvent software_events[] = {
    {"page-faults", PERF_COUNT_SW_PAGE_FAULTS, true, "pages mapped in at a first touch"},
    {"minor-faults", PERF_COUNT_SW_PAGE_FAULTS_MIN, true, "those without reading a disk"},
    {"major-faults", PERF_COUNT_SW_PAGE_FAULTS_MAJ, false, "those read from a disk"},
    {"context-switches", PERF_COUNT_SW_CONTEXT_SWITCHES, true, "times the thread left its processor"},
    {"cpu-migrations", PERF_COUNT_SW_CPU_MIGRATIONS, false, "times the thread changed its processor"},
    {"task-clock", PERF_COUNT_SW_TASK_CLOCK, true, "time on a processor", "ns"},
};

/// See reference_work. False when the system gives no memory.
bool do_reference_work() {
    const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t bytes = 256 * page;
    void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return false;
    // One page fault per page; a huge page would take them all in one. May fail where there are none.
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

CounterRecord read_counter(const ChosenEvent& event) {
    CounterRecord record{event, std::nullopt};
    if (!event.refusal.reason.empty()) return record;
    CounterGroup counter(std::span(&event.code, 1));
    if (!counter.start() || !do_reference_work()) {
        record.refusal = {"opened, but the kernel gave no count", "try again"};
        return record;
    }
    const Expected<GroupCount> count = counter.stop();
    if (!count.value) {
        record.refusal = count.refusal();
    } else if (count.value->values[0] == 0 && record.must_happen) {
        record.refusal = {"counted 0 over work that must cause it: this counter does not work here",
                          "run outside the virtual machine or container"};
    } else {
        record.value = count.value->values[0];
    }
    return record;
}

}  // namespace

std::vector<CounterRecord> read_counters(const Cpu& cpu) {
    std::vector<CounterRecord> records;
    for (const MetricName& metric : metrics) records.push_back(read_counter(choose_event(metric, cpu)));
    for (const SoftwareEvent& software : software_events) {
        ChosenEvent event = software_event(software.name, software.config, software.meaning, cpu);
        event.must_happen = software.must_happen;
        event.unit = software.unit;
        records.push_back(read_counter(event));
    }
    return records;
}

}  // namespace edgewise::measure
