// SPDX-License-Identifier: MIT
//
// The kernel's generic events ("perf list hw cache") that answer a metric. The same generic event is another
// thing on another maker's processor: "cache-misses" is the last level on Intel, the second level on AMD and
// the first on Arm. So one is taken only where it counts what the metric says.
#pragma once

#include <string_view>

#include "edgewise/measure/counters/perf_event.hpp"
#include "edgewise/measure/machine/processor.hpp"
#include "edgewise/measure/metric.hpp"

namespace edgewise::measure {

struct GenericEvent {
    Metric metric;
    CpuMaker maker;  ///< CpuMaker::other: every maker
    EventCode code;
    std::string_view level, meaning;
};

/// Null: none that counts this on a processor of that maker.
[[nodiscard]] const GenericEvent* find_generic(Metric metric, CpuMaker maker);

}  // namespace edgewise::measure
