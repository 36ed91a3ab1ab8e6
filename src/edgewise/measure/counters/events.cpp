// SPDX-License-Identifier: MIT
#include "edgewise/measure/counters/events.hpp"

#include <fmt/core.h>
#include <linux/perf_event.h>

#include <cerrno>
#include <cstring>

#include "edgewise/measure/counters/counter_group.hpp"
#include "edgewise/measure/counters/event_table.hpp"

namespace edgewise::measure {

namespace {

constexpr std::string_view own_event = "libpfm", generic_event = "generic";

/// An event by libpfm's name, with its PMU.
struct NamedEvent {
    std::string_view by;
    std::string name, meaning;
};

/// Named events in the order in which they are tried.
std::vector<NamedEvent> names_of(const MetricName& metric, const Cpu& cpu) {
    std::vector<NamedEvent> names;
    const Processor* const processor = find_processor(cpu);
    if (const EventRow* const row = processor ? find_event(metric.metric, processor->generation) : nullptr)
        names.push_back({own_event, fmt::format("{}::{}", processor->pmu, row->name), meaning(*row)});
    if (const GenericEvent* const generic = find_generic(metric.metric, maker_of(cpu)))
        names.push_back(
            {generic_event, fmt::format("perf::{}", generic->name), std::string(generic->meaning)});
    return names;
}

/// The errno of opening the event; 0 if it opens.
int error_of(const EventCode& code) { return CounterGroup(std::span(&code, 1)).error(); }

Refusal why_no_event(const MetricName& metric, const Cpu& cpu) {
    if (const auto names = names_of(metric, cpu); !names.empty())
        return {encode_by_libpfm(names.front().name).reason,
                "build with a version of libpfm4 that knows the event"};
    const Processor* const processor = find_processor(cpu);
    const std::string where = processor != nullptr
                                  ? std::string(processor->name)
                                  : fmt::format("this processor ({})", cpu.name.value.value_or("unknown"));
    return {fmt::format("no event that counts this is known on {}", where),
            fmt::format("measure on one of: {}", processors_with(metric.metric))};
}

}  // namespace

std::string encoding_text(const EventCode& code) {
    const char* const type = code.type == PERF_TYPE_HARDWARE   ? "PERF_TYPE_HARDWARE"
                             : code.type == PERF_TYPE_HW_CACHE ? "PERF_TYPE_HW_CACHE"
                             : code.type == PERF_TYPE_SOFTWARE ? "PERF_TYPE_SOFTWARE"
                             : code.type == PERF_TYPE_RAW      ? "PERF_TYPE_RAW"
                                                               : nullptr;
    const std::string name = type != nullptr ? type : fmt::format("type {}", code.type);
    return fmt::format("{}:{:#x}{}", name, code.config, code.kernel_too ? "" : ":u");
}

Refusal explain_error(int error, bool hardware, const Cpu& cpu) {
    const bool guest = cpu.hypervisor.value.value_or(false);
    const std::string words = std::strerror(error);
    const auto is_one_of = [&](auto... codes) { return ((error == codes) || ...); };
    if (is_one_of(EACCES, EPERM)) {
        return {"no permission: " + words,
                "as root: sysctl kernel.perf_event_paranoid=1, or give the program CAP_PERFMON; "
                "in a container also allow perf_event_open in its seccomp profile"};
    }
    if (is_one_of(ENOENT, EOPNOTSUPP, ENODEV) && hardware && guest) {
        return {"this virtual machine has no performance counters for it: " + words,
                "have the hypervisor pass the PMU through (KVM: -cpu host,pmu=on), or run on the bare "
                "machine"};
    }
    if (is_one_of(ENOENT, EOPNOTSUPP, ENODEV, EINVAL)) {
        return {"this processor or kernel does not have the event: " + words,
                "use a kernel that knows the processor"};
    }
    if (error == ENOSYS) {
        return {"the kernel has no perf_event_open: " + words,
                "use a kernel with CONFIG_PERF_EVENTS, outside of a sandbox that emulates system calls"};
    }
    if (is_one_of(EBUSY, EMFILE, ENOSPC)) {
        return {"no counter or file descriptor free: " + words,
                "end other users of the counters, or raise ulimit -n"};
    }
    return {words, "see man 2 perf_event_open"};
}

std::vector<ChosenEvent> event_candidates(const MetricName& metric, const Cpu& cpu) {
    std::vector<ChosenEvent> found;
    for (const auto& [by, name, meaning] : names_of(metric, cpu)) {
        const Expected<EventCode> code = encode_by_libpfm(name);
        if (!code.value) continue;
        const std::string encoding = encoding_text(*code.value);
        found.push_back({std::string(metric.name), std::string(by),
                         by == own_event ? fmt::format("{} = {}", name, encoding) : encoding,
                         std::string(metric.level), meaning});
        found.back().code = *code.value;
        found.back().must_happen = metric.must_happen;
    }
    return found;
}

ChosenEvent choose_event(const MetricName& metric, const Cpu& cpu) {
    const std::vector<ChosenEvent> candidates = event_candidates(metric, cpu);
    if (candidates.empty()) {
        ChosenEvent none{std::string(metric.name), "none", "none", std::nullopt, "not known here"};
        none.must_happen = metric.must_happen;
        none.refusal = why_no_event(metric, cpu);
        return none;
    }
    ChosenEvent first = candidates.front();
    for (const ChosenEvent& candidate : candidates) {
        const int error = error_of(candidate.code);
        if (error == 0) return candidate;
        if (first.error == 0) first.error = error;
    }
    first.refusal = explain_error(first.error, true, cpu);
    return first;
}

const std::vector<ChosenEvent>& chosen_events(const Cpu& cpu) {
    static const std::vector<ChosenEvent> chosen = [&] {
        std::vector<ChosenEvent> events;
        for (const MetricName& metric : metrics) events.push_back(choose_event(metric, cpu));
        return events;
    }();
    return chosen;
}

/// Context switches and migrations are counted in the kernel too: they happen there, and a count of user mode
/// only would be 0 without any error.
ChosenEvent software_event(std::string_view name, std::uint64_t config, std::string_view meaning,
                           const Cpu& cpu) {
    const bool in_kernel = config == PERF_COUNT_SW_CONTEXT_SWITCHES || config == PERF_COUNT_SW_CPU_MIGRATIONS;
    const EventCode code{PERF_TYPE_SOFTWARE, config, in_kernel};
    ChosenEvent event{std::string(name), "software", encoding_text(code), "kernel", std::string(meaning)};
    event.code = code;
    event.error = error_of(code);
    if (event.error != 0) event.refusal = explain_error(event.error, false, cpu);
    return event;
}

}  // namespace edgewise::measure
