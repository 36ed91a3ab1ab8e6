// SPDX-License-Identifier: MIT
#include "edgewise/measure/counters/event_choice.hpp"

#include <fmt/core.h>
#include <linux/perf_event.h>

#include "edgewise/measure/counters/event_table.hpp"
#include "edgewise/measure/counters/generic_event.hpp"
#include "edgewise/measure/counters/libpfm.hpp"
#include "edgewise/measure/counters/perf_error.hpp"
#include "edgewise/measure/machine/processor.hpp"

namespace edgewise::measure {

namespace {

ChosenEvent named(const MetricName& metric, std::string by) {
    ChosenEvent event;
    event.event = metric.name;
    event.by = std::move(by);
    event.must_happen = metric.must_happen;
    return event;
}

ChosenEvent from_row(const MetricName& metric, std::string by, const EventRow& row, const EventCode& code) {
    ChosenEvent event = named(metric, std::move(by));
    event.code = code;
    event.encoding = encoding_text(code);
    event.level = row.level;
    event.meaning = meaning(row);
    return event;
}

void add_of_processor(std::vector<ChosenEvent>& found, const MetricName& metric, const Processor& processor) {
    const EventRow* const row = find_event(metric.metric, processor.generation);
    if (row == nullptr) return;
    const std::string name = fmt::format("{}::{}", processor.pmu, row->name);
    if (const Expected<EventCode> code = encode_by_libpfm(name); code.value) {
        found.push_back(from_row(metric, "libpfm", *row, *code.value));
        found.back().encoding = fmt::format("{} = {}", name, encoding_text(*code.value));
    }
    found.push_back(from_row(metric, "raw", *row, {PERF_TYPE_RAW, row->config}));
}

void add_generic(std::vector<ChosenEvent>& found, const MetricName& metric, const Cpu& cpu) {
    const GenericEvent* const generic = find_generic(metric.metric, maker_of(cpu));
    if (generic == nullptr) return;
    ChosenEvent event = named(metric, "generic");
    event.code = generic->code;
    event.encoding = encoding_text(generic->code);
    event.level = generic->level;
    event.meaning = generic->meaning;
    found.push_back(std::move(event));
}

/// Nothing known counts it here.
ChosenEvent no_event(const MetricName& metric, const Cpu& cpu) {
    ChosenEvent event = named(metric, "none");
    event.meaning = "not known here";
    const Processor* const processor = find_processor(cpu);
    const std::string where = processor != nullptr
                                  ? std::string(processor->name)
                                  : fmt::format("this processor ({})", cpu.name.value.value_or("unknown"));
    event.refusal = {fmt::format("no event that counts this is known on {}", where),
                     fmt::format("measure on one of: {}", processors_with(metric.metric))};
    return event;
}

}  // namespace

std::vector<ChosenEvent> event_candidates(const MetricName& metric, const Cpu& cpu) {
    std::vector<ChosenEvent> found;
    if (const Processor* const processor = find_processor(cpu); processor != nullptr) {
        add_of_processor(found, metric, *processor);
    }
    add_generic(found, metric, cpu);
    return found;
}

ChosenEvent choose_event(const MetricName& metric, const Cpu& cpu) {
    const std::vector<ChosenEvent> candidates = event_candidates(metric, cpu);
    if (candidates.empty()) return no_event(metric, cpu);
    ChosenEvent first = candidates.front();
    for (const ChosenEvent& candidate : candidates) {
        const PerfEvent trial(candidate.code);
        if (trial.error() == 0) return candidate;
        if (first.error == 0) first.error = trial.error();
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

}  // namespace edgewise::measure
