// SPDX-License-Identifier: MIT
//
// The event that answers a metric on each processor: libpfm's name for it, and what exactly it counts.
// Processors differ in that, so every count is reported with its meaning. A metric that no event of a
// processor counts has no row for it.
//
// Also the kernel's generic events ("perf list hw cache"). One name means different things on different
// makers' processors: "cache-misses" is the last level on Intel, the second level on AMD and the first on
// Arm. So an event is taken only where it counts what the metric says.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "edgewise/measure/counters/event_code.hpp"
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
    unsigned generations;     ///< of processor.hpp, a set
    std::string_view name;    ///< libpfm's, without the PMU
    std::string_view counts;  ///< in words
    EventScope scope = EventScope::demand;
    EventTime time = EventTime::speculative;
};

struct GenericEvent {
    Metric metric;
    CpuMaker maker;  ///< CpuMaker::other: every maker
    EventCode code;
    std::string_view meaning;
};

[[nodiscard]] std::span<const EventRow> event_table();

/// Null: this processor has no such event.
[[nodiscard]] const EventRow* find_event(Metric metric, unsigned generation);

/// Null: none that counts this on a processor of that maker.
[[nodiscard]] const GenericEvent* find_generic(Metric metric, CpuMaker maker);

/// What a row counts, in one phrase.
[[nodiscard]] std::string meaning(const EventRow& row);

/// "Intel Skylake, AMD Zen 3": which processors have an event for the metric.
[[nodiscard]] std::string processors_with(Metric metric);

}  // namespace edgewise::measure
