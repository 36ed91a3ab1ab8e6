// SPDX-License-Identifier: MIT
//
// From a metric to an event that this machine counts: libpfm's name for it, else a generic event of the
// kernel, which may count at another level or other causes (event_table.hpp). If neither is found, the
// refusal says why.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/counters/event_code.hpp"
#include "edgewise/measure/metric.hpp"

namespace edgewise::measure {

struct ChosenEvent {
    std::string event;                 ///< the metric's name, or what perf calls a software event
    std::string by;                    ///< how it was found: libpfm, generic, software; none: not at all
    std::string encoding = "none";     ///< what is asked of the kernel, e.g. "PERF_TYPE_RAW:0x8d1:u"
    std::optional<std::string> level;  ///< what it counts: see MetricName, or "kernel"
    std::string meaning;               ///< the same in words
    std::string unit = "1";            ///< "1" or "ns"; per query where a value is
    EventCode code = {};
    bool must_happen = false;  ///< see MetricName
    int error = 0;             ///< errno of opening it; 0: none
    Refusal refusal = {};      ///< empty: it can be opened
};

/// In the order in which they are tried; `refusal` and `error` are not set.
[[nodiscard]] std::vector<ChosenEvent> event_candidates(const MetricName& metric, const Cpu& cpu);

/// The first that opens; when none does, the first candidate with why.
[[nodiscard]] ChosenEvent choose_event(const MetricName& metric, const Cpu& cpu);

/// One for every metric, found out at the first call and kept: `cpu` is this machine's, always the same.
[[nodiscard]] const std::vector<ChosenEvent>& chosen_events(const Cpu& cpu);

/// One of the kernel's own (PERF_COUNT_SW_*), or why it cannot be opened.
[[nodiscard]] ChosenEvent software_event(std::string_view name, std::uint64_t config,
                                         std::string_view meaning, const Cpu& cpu);

}  // namespace edgewise::measure
