// SPDX-License-Identifier: MIT
//
// Which event of which processor answers a metric: libpfm's name for it, its raw code for where libpfm does
// not know the processor, and what exactly it counts. Processors differ in that, so every count is reported
// with its level and its meaning. A metric that no event of a processor counts has no row for it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "edgewise/measure/machine/processor.hpp"
#include "edgewise/measure/metric.hpp"

namespace edgewise::measure {

/// Which causes an event counts.
enum class EventScope {
    demand,  ///< what instructions asked for
    all      ///< the prefetchers' too
};

/// When an event counts.
enum class EventTime {
    retired,     ///< only what the program truly did
    speculative  ///< also on paths that were dropped
};

struct EventRow {
    Metric metric;
    unsigned generations;   ///< of processor.hpp, a set
    std::string_view name;  ///< libpfm's, without the PMU
    std::uint64_t config;   ///< of PERF_TYPE_RAW: event, unit mask << 8
    std::string_view level;
    std::string_view counts;  ///< in words
    EventScope scope;
    EventTime time;
};

[[nodiscard]] std::span<const EventRow> event_table();

/// Null: this processor has no such event.
[[nodiscard]] const EventRow* find_event(Metric metric, unsigned generation);

/// What a row counts, in one phrase.
[[nodiscard]] std::string meaning(const EventRow& row);

/// "Intel Skylake, AMD Zen 3": which processors have an event for the metric.
[[nodiscard]] std::string processors_with(Metric metric);

}  // namespace edgewise::measure
