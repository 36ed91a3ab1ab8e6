// SPDX-License-Identifier: MIT
//
// Latency of a load that each cache level answers on this machine: loads that depend on each other, over
// memory that fits the level but not the level above it.
#pragma once

#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"

namespace edgewise::studies::advise {

/// Returns ns beyond a load that the first level answers, for each further level and then for memory; at
/// least zero. A level takes some milliseconds to measure, memory up to a second.
[[nodiscard]] std::vector<double> latencies_beyond_first(const measure::CacheMachine& host);

}  // namespace edgewise::studies::advise
