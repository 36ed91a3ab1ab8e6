// SPDX-License-Identifier: MIT
#include "edgewise/measure/counters/software_watch.hpp"

#include <linux/perf_event.h>

#include <string_view>

#include "edgewise/measure/counters/perf_error.hpp"

namespace edgewise::measure {

namespace {

// Moves happen inside the kernel, which filters every one of them out of a user-only count.
constexpr EventCode migrations_code{PERF_TYPE_SOFTWARE, PERF_COUNT_SW_CPU_MIGRATIONS, true};

PassRecord software_record(std::string_view event, std::string_view encoding, std::string_view meaning) {
    PassRecord record;
    record.event = event;
    record.by = "software";
    record.encoding = encoding;
    record.level = "kernel";
    record.meaning = meaning;
    return record;
}

PassRecord counted(PassRecord record, std::uint64_t count, std::size_t queries) {
    if (queries == 0) {
        record.refusal = {"no queries in the pass", "count a pass that has some"};
        return record;
    }
    record.value = static_cast<double>(count) / static_cast<double>(queries);
    record.samples = 1;
    return record;
}

}  // namespace

SoftwareWatch::SoftwareWatch(const Cpu& cpu) : cpu_(cpu), migrations_(migrations_code) {}

void SoftwareWatch::start() {
    migrations_.start();  // a failure shows in stop()
    before_ = thread_usage();
}

std::vector<PassRecord> SoftwareWatch::stop(std::size_t queries) {
    const ThreadUsage during = thread_usage() - before_;
    return {counted(software_record("minor_faults", "getrusage(RUSAGE_THREAD).ru_minflt",
                                    "pages mapped in without reading a disk"),
                    during.minor_faults, queries),
            counted(software_record("major_faults", "getrusage(RUSAGE_THREAD).ru_majflt",
                                    "pages read from a disk"),
                    during.major_faults, queries),
            counted(software_record("context_switches", "getrusage(RUSAGE_THREAD).ru_nvcsw+ru_nivcsw",
                                    "times the thread left its processor"),
                    during.context_switches, queries),
            migrations(queries)};
}

PassRecord SoftwareWatch::migrations(std::size_t queries) {
    PassRecord record = software_record("cpu_migrations", encoding_text(migrations_code),
                                        "times the thread changed its processor");
    record.code = migrations_code;
    record.error = migrations_.error();
    if (record.error != 0) {
        record.refusal = explain_error(record.error, false, cpu_);
        return record;
    }
    const std::optional<EventCount> count = migrations_.stop();
    if (!count) {
        record.refusal = {"opened, but the kernel gave no count", "try again"};
        return record;
    }
    return counted(std::move(record), count->value, queries);
}

std::vector<PassRecord> count_software(const std::function<void()>& pass, std::size_t queries,
                                       const Cpu& cpu) {
    SoftwareWatch watch(cpu);
    watch.start();
    pass();
    return watch.stop(queries);
}

}  // namespace edgewise::measure
