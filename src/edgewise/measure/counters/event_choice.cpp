// SPDX-License-Identifier: MIT
#include "edgewise/measure/counters/event_choice.hpp"

#include <fmt/core.h>
#include <linux/perf_event.h>

#include "edgewise/measure/counters/counter_group.hpp"
#include "edgewise/measure/counters/event_table.hpp"
#include "edgewise/measure/counters/libpfm.hpp"

namespace edgewise::measure {

namespace {

ChosenEvent event_by(const MetricName& metric, std::string by, const EventCode& code, std::string meaning) {
    ChosenEvent event{std::string(metric.name), std::move(by), encoding_text(code), std::string(metric.level),
                      std::move(meaning)};
    event.code = code;
    event.must_happen = metric.must_happen;
    return event;
}

/// libpfm's name of the processor's own event; "" where the processor has none.
std::string own_event(const MetricName& metric, const Processor* processor) {
    const EventRow* const row =
        processor == nullptr ? nullptr : find_event(metric.metric, processor->generation);
    return row == nullptr ? "" : fmt::format("{}::{}", processor->pmu, row->name);
}

/// The errno of opening it; 0: it opens.
int error_of(const EventCode& code) { return CounterGroup(std::span(&code, 1)).error(); }

Refusal why_no_event(const MetricName& metric, const Processor* processor, const Cpu& cpu) {
    if (const std::string name = own_event(metric, processor); !name.empty())
        return {encode_by_libpfm(name).reason, "build with a version of libpfm4 that knows the event"};
    const std::string where = processor != nullptr
                                  ? std::string(processor->name)
                                  : fmt::format("this processor ({})", cpu.name.value.value_or("unknown"));
    return {fmt::format("no event that counts this is known on {}", where),
            fmt::format("measure on one of: {}", processors_with(metric.metric))};
}

/// Nothing known counts it here.
ChosenEvent no_event(const MetricName& metric, const Cpu& cpu) {
    ChosenEvent event{std::string(metric.name), "none", "none", std::nullopt, "not known here"};
    event.must_happen = metric.must_happen;
    event.refusal = why_no_event(metric, find_processor(cpu), cpu);
    return event;
}

}  // namespace

std::vector<ChosenEvent> event_candidates(const MetricName& metric, const Cpu& cpu) {
    std::vector<ChosenEvent> found;
    const Processor* const processor = find_processor(cpu);
    if (const std::string name = own_event(metric, processor); !name.empty()) {
        const EventRow& row = *find_event(metric.metric, processor->generation);
        if (const Expected<EventCode> code = encode_by_libpfm(name); code.value) {
            ChosenEvent& event = found.emplace_back(event_by(metric, "libpfm", *code.value, meaning(row)));
            event.encoding = fmt::format("{} = {}", name, event.encoding);
        }
    }
    if (const GenericEvent* const generic = find_generic(metric.metric, maker_of(cpu)); generic != nullptr)
        found.push_back(event_by(metric, "generic", generic->code, std::string(generic->meaning)));
    return found;
}

ChosenEvent choose_event(const MetricName& metric, const Cpu& cpu) {
    const std::vector<ChosenEvent> candidates = event_candidates(metric, cpu);
    if (candidates.empty()) return no_event(metric, cpu);
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

/// Departure from "user mode only": context switches and migrations happen inside the kernel, so that it
/// filters every one of them out of a user-only count, which then is a perfect 0 without any error.
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
