// SPDX-License-Identifier: MIT
//
// A group that the kernel does not take, or has no counters for, is halved until it fits: how many counters
// are free depends on the processor, on hyperthreading and on the watchdog.
#include "edgewise/measure/counters/count_pass.hpp"

#include <fmt/core.h>
#include <linux/perf_event.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <utility>

#include "edgewise/measure/counters/counter_group.hpp"
#include "edgewise/measure/process/thread_usage.hpp"

namespace edgewise::measure {

namespace {

class PassCounter {
  public:
    PassCounter(const std::function<void()>& pass, std::size_t queries, const CountOptions& options)
        : pass_(pass), queries_(queries), options_(options) {}

    void count(std::span<PassRecord* const> records) {
        std::vector<EventCode> codes;
        for (const PassRecord* record : records) codes.push_back(record->code);
        CounterGroup group(codes);
        if (group.error() != 0) {
            return halve_or_refuse(records, {"the event opened before, but not now",
                                             "end other users of the counters, or raise ulimit -n"});
        }
        const Expected<Batches> empty = count_empty(group, records.size());
        if (!empty.value) return halve_or_refuse(records, empty.refusal());
        const Expected<Samples> samples = count_passes(group, records.size());
        if (!samples.value) return halve_or_refuse(records, samples.refusal());
        for (std::size_t k = 0; k < records.size(); ++k)
            conclude(*records[k], (*empty.value)[k], (*samples.value)[k]);
    }

    [[nodiscard]] std::size_t passes() const { return passes_; }

  private:
    using Batches = std::array<std::vector<std::uint64_t>, largest_group>;
    using Samples = std::array<std::vector<CounterSample>, largest_group>;

    Expected<GroupCount> count_once(CounterGroup& group, const std::function<void()>& work) {
        if (!group.start())
            return Refusal{"the kernel does not take these events together",
                           "end other users of the counters"};
        work();
        return group.stop();
    }

    Expected<Batches> count_empty(CounterGroup& group, std::size_t events) {
        Batches batches;
        for (std::size_t i = 0; i < options_.empty_batches; ++i) {
            const Expected<GroupCount> count = count_once(group, [] {});
            if (!count.value) return count.refusal();
            for (std::size_t k = 0; k < events; ++k) batches[k].push_back(count.value->values[k]);
        }
        return {std::move(batches)};
    }

    Expected<Samples> count_passes(CounterGroup& group, std::size_t events) {
        Samples samples;
        std::size_t good = 0;
        for (std::size_t i = 0; i < options_.most_passes && good < options_.samples; ++i) {
            const int processor = sched_getcpu();
            const ThreadUsage before = thread_usage();
            const Expected<GroupCount> count = count_once(group, pass_);
            const ThreadUsage during = thread_usage() - before;
            ++passes_;
            if (!count.value) return count.refusal();
            CounterSample sample{0, count.value->enabled_ns, count.value->running_ns};
            sample.page_faults = during.minor_faults + during.major_faults;
            sample.context_switches = during.context_switches;
            sample.migrations = sched_getcpu() != processor ? 1 : 0;
            if (!sample.is_disturbed()) ++good;
            for (std::size_t k = 0; k < events; ++k) {
                sample.count = count.value->values[k];
                samples[k].push_back(sample);
            }
        }
        return {std::move(samples)};
    }

    void halve_or_refuse(std::span<PassRecord* const> records, const Refusal& refusal) {
        if (records.size() == 1) {
            records.front()->refusal = refusal;
            return;
        }
        count(records.first(records.size() / 2));
        count(records.subspan(records.size() / 2));
    }

    void conclude(PassRecord& record, std::span<const std::uint64_t> empty,
                  std::span<const CounterSample> samples) const {
        const Expected<CountingCost> cost = counting_cost(empty);
        if (!cost.value) {
            record.refusal = cost.refusal();
            return;
        }
        record.overhead = cost.value->overhead;
        record.floor = cost.value->floor;
        const Expected<CounterFigure> figure = count_per_query(samples, *cost.value, queries_);
        if (!figure.value) {
            record.refusal = figure.refusal();
            return;
        }
        record.value = figure.value->per_query;
        record.samples = figure.value->samples;
        record.dropped = figure.value->dropped;
    }

    const std::function<void()>& pass_;
    std::size_t queries_;
    CountOptions options_;
    std::size_t passes_ = 0;
};

PassRecord per_query(ChosenEvent event, std::uint64_t count, std::size_t queries) {
    PassRecord record{std::move(event)};
    if (queries == 0) {
        record.refusal = {"no queries in the pass", "count a pass that has some"};
    } else {
        record.value = static_cast<double>(count) / static_cast<double>(queries);
        record.samples = 1;
    }
    return record;
}

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

CountedPass count_events(const std::function<void()>& pass, std::size_t queries,
                         std::span<const ChosenEvent> events, const CountOptions& options) {
    CountedPass result;
    for (const ChosenEvent& event : events) result.records.push_back({event});
    PassCounter counter(pass, queries, options);
    // Groups are cut from all events, open or not, so that they are the same on every machine.
    for (std::size_t first = 0; first < events.size(); first += largest_group) {
        std::vector<PassRecord*> group;
        for (std::size_t i = first; i < std::min(first + largest_group, events.size()); ++i) {
            if (events[i].refusal.reason.empty()) group.push_back(&result.records[i]);
        }
        if (!group.empty()) counter.count(group);
    }
    result.passes = counter.passes();
    return result;
}

CountedPass count_pass(const std::function<void()>& pass, std::size_t queries, const Cpu& cpu) {
    return count_events(pass, queries, chosen_events(cpu));
}

std::vector<PassRecord> count_software(const std::function<void()>& pass, std::size_t queries,
                                       const Cpu& cpu) {
    ChosenEvent moves = software_event("cpu_migrations", PERF_COUNT_SW_CPU_MIGRATIONS,
                                       "times the thread changed its processor", cpu);
    CounterGroup group(std::span(&moves.code, 1));
    group.start();  // a failure shows in stop()
    const ThreadUsage before = thread_usage();
    pass();
    const ThreadUsage during = thread_usage() - before;
    const Expected<GroupCount> moved = group.stop();
    const auto by_usage = [&](std::string name, const char* members, std::string meaning,
                              std::uint64_t count) {
        const std::string encoding = fmt::format("getrusage(RUSAGE_THREAD).{}", members);
        return per_query({std::move(name), "software", encoding, "kernel", std::move(meaning)}, count,
                         queries);
    };
    std::vector<PassRecord> records = {
        by_usage("minor_faults", "ru_minflt", "pages mapped in without reading a disk", during.minor_faults),
        by_usage("major_faults", "ru_majflt", "pages read from a disk", during.major_faults),
        by_usage("context_switches", "ru_nvcsw+ru_nivcsw", "times the thread left its processor",
                 during.context_switches)};
    if (moves.error == 0) moves.refusal = moved.refusal();
    if (moved.value) {
        records.push_back(per_query(std::move(moves), moved.value->values[0], queries));
    } else {
        records.push_back({std::move(moves)});
    }
    return records;
}

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
