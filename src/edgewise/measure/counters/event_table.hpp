// SPDX-License-Identifier: MIT
//
// The event that answers a metric on each processor: libpfm's name for it, and what exactly it counts.
// Processors differ in that, so every count is reported with its meaning. A metric that no event of a
// processor counts has no row for it.
//
// Also the kernel's generic events ("perf list hw cache"), for processors that have no row. A generic name
// means different things on different makers' processors: "cache-misses" is the last level on Intel, the
// second level on AMD and the first on Arm. So a generic event is taken only where it counts what the metric
// says.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "edgewise/measure/counters/events.hpp"
#include "edgewise/measure/machine/machine.hpp"

namespace edgewise::measure {

enum class CpuMaker { intel, amd, arm, other };

/// Processors with the same events; a bit each, so that a set of them is a sum. Processors are distinguished
/// as libpfm does: by vendor, family, model and stepping.
namespace generation {
inline constexpr unsigned skylake = 1;  ///< to Ice Lake
inline constexpr unsigned sapphire_rapids = 2;
inline constexpr unsigned zen2 = 4, zen3 = 8, zen4 = 16, zen5 = 32;
inline constexpr unsigned neoverse_n1 = 64, neoverse_v2 = 128;
inline constexpr unsigned k7 = 256;
}  // namespace generation

/// Numbers first .. last; one number if no last is given.
struct NumberRange {
    std::int64_t first = -1, last = first;

    [[nodiscard]] constexpr bool holds(std::int64_t number) const {
        return first >= 0 && first <= number && number <= last;
    }
};

struct Processor {
    std::string_view pmu;  ///< libpfm's name
    std::string_view name;
    unsigned generation;  ///< one bit
    CpuMaker maker;
    std::int64_t family;    ///< Arm: the architecture, always 8
    NumberRange models[5];  ///< unused ones hold no number
    NumberRange steppings = {0, 0xffff};
};

/// The processors with known events, each once.
[[nodiscard]] std::span<const Processor> processors();

/// Null for a processor that is not in the table.
[[nodiscard]] const Processor* find_processor(const Cpu& cpu);

/// Maker of the processor, from the vendor's name in /proc/cpuinfo.
[[nodiscard]] CpuMaker maker_of(const Cpu& cpu);

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
    unsigned generations;     ///< a set of bits of namespace generation
    std::string_view name;    ///< libpfm's, without the PMU
    std::string_view counts;  ///< in words
    EventScope scope = EventScope::demand;
    EventTime time = EventTime::speculative;
};

struct GenericEvent {
    Metric metric;
    CpuMaker maker;         ///< CpuMaker::other: every maker
    std::string_view name;  ///< libpfm's, of the PMU "perf"
    std::string_view meaning;
};

[[nodiscard]] std::span<const EventRow> event_table();

/// Null if this processor has no such event.
[[nodiscard]] const EventRow* find_event(Metric metric, unsigned generation);

/// Null if no generic event counts this on a processor of that maker.
[[nodiscard]] const GenericEvent* find_generic(Metric metric, CpuMaker maker);

/// What a row counts, in one phrase.
[[nodiscard]] std::string meaning(const EventRow& row);

/// Names of the processors that have an event for the metric, as "Intel Skylake, AMD Zen 3".
[[nodiscard]] std::string processors_with(Metric metric);

}  // namespace edgewise::measure
