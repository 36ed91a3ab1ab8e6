// SPDX-License-Identifier: MIT
//
// Departure from "user mode only": context-switches and cpu-migrations happen inside the kernel, so that the
// kernel filters every one of them out of a user-only count, which then is a perfect 0 without any error.
#include "edgewise/measure/counters/counters.hpp"

#include <fmt/core.h>
#include <linux/perf_event.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <string>

#include "edgewise/measure/counters/perf_error.hpp"
#include "edgewise/measure/counters/perf_event.hpp"

namespace edgewise::measure {

namespace {

struct SoftwareEvent {
    std::string_view name;
    EventCode code;
    bool must_happen;  ///< the reference work causes it for certain
    std::string_view meaning;
    std::string_view unit = "1";
};

constexpr std::array<SoftwareEvent, 6> software_events{{
    {"page-faults",
     {PERF_TYPE_SOFTWARE, PERF_COUNT_SW_PAGE_FAULTS},
     true,
     "pages mapped in at a first touch"},
    {"minor-faults",
     {PERF_TYPE_SOFTWARE, PERF_COUNT_SW_PAGE_FAULTS_MIN},
     true,
     "those without reading a disk"},
    {"major-faults", {PERF_TYPE_SOFTWARE, PERF_COUNT_SW_PAGE_FAULTS_MAJ}, false, "those read from a disk"},
    {"context-switches",
     {PERF_TYPE_SOFTWARE, PERF_COUNT_SW_CONTEXT_SWITCHES, true},
     true,
     "times the thread left its processor"},
    {"cpu-migrations",
     {PERF_TYPE_SOFTWARE, PERF_COUNT_SW_CPU_MIGRATIONS, true},
     false,
     "times the thread changed its processor"},
    {"task-clock", {PERF_TYPE_SOFTWARE, PERF_COUNT_SW_TASK_CLOCK}, true, "time on a processor", "ns"},
}};

ChosenEvent choose_software(const SoftwareEvent& software, const Cpu& cpu) {
    ChosenEvent event;
    event.event = software.name;
    event.by = "software";
    event.encoding = encoding_text(software.code);
    event.level = "kernel";
    event.meaning = software.meaning;
    event.unit = software.unit;
    event.code = software.code;
    event.must_happen = software.must_happen;
    event.error = PerfEvent(software.code).error();
    if (event.error != 0) event.refusal = explain_error(event.error, false, cpu);
    return event;
}

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

void set_unavailable(CounterRecord& record, std::string reason, std::string remedy) {
    record.value.reset();
    record.refusal = {std::move(reason), std::move(remedy)};
}

void judge(CounterRecord& record, const EventCount& count) {
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
    } else if (count.value == 0 && record.must_happen) {
        set_unavailable(record, "counted 0 over work that must cause it: this counter does not work here",
                        "run outside the virtual machine or container");
    } else {
        record.value = count.value;
    }
}

CounterRecord read_counter(const ChosenEvent& event) {
    CounterRecord record{event, std::nullopt};
    if (!event.refusal.reason.empty()) return record;
    PerfEvent counter(event.code);
    const bool worked = counter.start() && do_reference_work();
    const std::optional<EventCount> count = counter.stop();
    if (worked && count) {
        judge(record, *count);
    } else {
        set_unavailable(record, "opened, but the kernel gave no count", "try again");
    }
    return record;
}

}  // namespace

std::vector<CounterRecord> read_counters(const Cpu& cpu) {
    std::vector<CounterRecord> records;
    for (const MetricName& metric : metrics) records.push_back(read_counter(choose_event(metric, cpu)));
    for (const SoftwareEvent& event : software_events) {
        records.push_back(read_counter(choose_software(event, cpu)));
    }
    return records;
}

}  // namespace edgewise::measure
