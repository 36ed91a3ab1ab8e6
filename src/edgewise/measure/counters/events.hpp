// SPDX-License-Identifier: MIT
//
// Events that a processor counts: metrics, by names that mean the same on every processor; the event that
// answers a metric on this machine, as libpfm4 and the Linux kernel know it; and what the kernel's refusals
// mean (man 2 perf_event_open).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/expected.hpp"
#include "edgewise/measure/machine/machine.hpp"

namespace edgewise::measure {

struct EventCode {
    std::uint32_t type = 0;    ///< PERF_TYPE_*
    std::uint64_t config = 0;  ///< of that type
    bool kernel_too = false;   ///< else only what happens in user mode
};

/// Text of a code, as "PERF_TYPE_RAW:0x8d1:u"; u: user mode only.
[[nodiscard]] std::string encoding_text(const EventCode& code);

/// Why an event cannot be opened, and what helps. `error`: the errno. `hardware`: the event is the
/// processor's, not the kernel's own.
[[nodiscard]] Refusal explain_error(int error, bool hardware, const Cpu& cpu);

struct MetricName {
    std::string_view name;
    std::string_view level;  ///< of the caches, where it is about them: "core", "L1D", "L2", "LLC" ...
    bool must_happen;  ///< in any work of many thousand loads over more memory than the first cache holds
};

/// In the order of reports. Four in a row are counted together, so ratios within such a row are of the same
/// run.
inline constexpr std::array<MetricName, 12> metrics{{
    {"instructions", "core", true},
    {"cycles", "core", true},
    {"branches", "core", true},
    {"branch_misses", "core", false},
    {"loads", "core", true},
    {"stores", "core", true},
    {"l1d_fills", "L1D", true},
    {"l1d_load_misses", "L1D", true},
    {"l2_demand_misses", "L2", false},
    {"llc_misses", "LLC", false},
    {"dtlb_walks", "dTLB, page walks", false},
    {"line_crossing_loads", "L1D", false},
}};

/// Why libpfm cannot be used: it was left out of this build, or did not start. Empty if it can be used.
[[nodiscard]] std::string why_no_libpfm();

/// The code of an event with a name like "skx::MEM_LOAD_RETIRED:L1_MISS", in user mode only. The processor
/// need not be this machine's.
[[nodiscard]] Expected<EventCode> encode_by_libpfm(const std::string& name);

/// An event for a metric: the processor's own, or a generic one of the kernel.
struct ChosenEvent {
    std::string event;                 ///< the metric's name, or what perf calls a software event
    std::string by;                    ///< source of the event: libpfm, generic, software; or none
    std::string encoding = "none";     ///< what is asked of the kernel, e.g. "PERF_TYPE_RAW:0x8d1:u"
    std::optional<std::string> level;  ///< what it counts: see MetricName, or "kernel"
    std::string meaning;               ///< what it counts, in words
    std::string unit = "1";            ///< "1" or "ns"; per query where a value is
    EventCode code = {};
    bool must_happen = false;  ///< see MetricName
    int error = 0;             ///< errno of opening it; 0: none
    Refusal refusal = {};      ///< empty: it can be opened
};

/// Events that may answer the metric, in the order in which they are tried: the processor's own, then a
/// generic event of the kernel. None without libpfm. `refusal` and `error` are not set.
[[nodiscard]] std::vector<ChosenEvent> event_candidates(const MetricName& metric, const Cpu& cpu);

/// The first candidate that opens. If none does: the first candidate, with the reason.
[[nodiscard]] ChosenEvent choose_event(const MetricName& metric, const Cpu& cpu);

/// The event of every metric, chosen at the first call and kept. `cpu`: this machine's.
[[nodiscard]] const std::vector<ChosenEvent>& chosen_events(const Cpu& cpu);

/// An event of the kernel's own (PERF_COUNT_SW_*), with the reason if it cannot be opened.
[[nodiscard]] ChosenEvent software_event(std::string_view name, std::uint64_t config,
                                         std::string_view meaning, const Cpu& cpu);

// The event that answers a metric on each processor: libpfm's name for it, and what exactly it counts.
// Processors differ in that, so every count is reported with its meaning. A metric that no event of a
// processor counts has no row for it.
//
// Also the kernel's generic events ("perf list hw cache"), for processors that have no row. A generic name
// means different things on different makers' processors: "cache-misses" is the last level on Intel, the
// second level on AMD and the first on Arm. So a generic event is taken only where it counts what the metric
// says.

enum class CpuMaker { intel, amd, arm, other };

/// Numbers first .. last; one number if no last is given.
struct NumberRange {
    std::int64_t first = -1, last = first;

    [[nodiscard]] constexpr bool holds(std::int64_t number) const {
        return first >= 0 && first <= number && number <= last;
    }
};

/// Processors are distinguished as libpfm does: by vendor, family, model and stepping.
struct Processor {
    std::string_view pmu;  ///< libpfm's name
    std::string_view name;
    std::string_view generation;  ///< processors of one have the same events
    CpuMaker maker;
    std::int64_t family;    ///< Arm: the architecture, always 8
    NumberRange models[5];  ///< unused ones hold no number
    NumberRange steppings = {0, 0xffff};
};

/// The processors with known events, each once.
[[nodiscard]] std::span<const Processor> processors();

/// Null for a processor that is not in the table.
[[nodiscard]] const Processor* find_processor(const Cpu& cpu);

struct EventRow {
    MetricName metric;
    std::vector<std::string> generations;  ///< of the processors that have it
    std::string name;                      ///< libpfm's, without the PMU
    std::string counts;                    ///< in words
    bool prefetches = false;  ///< counts what the prefetchers asked for too; else only what instructions did
    bool retired = false;     ///< counts what the program truly did; else also on paths that were dropped
};

struct GenericEvent {
    std::string_view metric;
    CpuMaker maker;    ///< CpuMaker::other: every maker
    std::string name;  ///< libpfm's, of the PMU "perf"
    std::string meaning;
};

/// The text of events.json: for each metric the rows of event_table, then the generic events.
extern const char* const event_texts;

[[nodiscard]] std::span<const EventRow> event_table();

/// Null if this processor has no such event.
[[nodiscard]] const EventRow* find_event(std::string_view metric, std::string_view generation);

/// Null if no generic event counts this on a processor of that maker.
[[nodiscard]] const GenericEvent* find_generic(std::string_view metric, CpuMaker maker);

/// What a row counts, in one phrase.
[[nodiscard]] std::string meaning(const EventRow& row);

}  // namespace edgewise::measure
