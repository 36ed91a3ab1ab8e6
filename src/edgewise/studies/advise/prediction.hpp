// SPDX-License-Identifier: MIT
//
// Predicts the time of a query from its modelled misses, to be shown next to the measured time.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"

namespace edgewise::studies::advise {

// Latency of a load that each cache level answers on this machine: loads that depend on each other, over
// memory that fits the level but not the level above it.

/// Returns ns beyond a load that the first level answers, for each further level and then for memory; at
/// least zero. A level takes some milliseconds to measure, memory up to a second.
[[nodiscard]] std::vector<double> latencies_beyond_first(const measure::CacheMachine& host);

/// Name of this machine among the machines with modelled caches.
inline constexpr const char* this_machine = "host";

/// Cost of cache misses for one cell.
struct CacheCost {
    std::optional<double> in_cache_ns;  ///< per query, few bodies with one table; null: no time was left
    /// Modelled misses per query, by machine, level by level from the first on.
    std::map<std::string, std::vector<double>> misses;
    std::map<std::string, double> predicted_ns;  ///< per query, by machine
};

/// Predicts for each machine with modelled misses: the time in cache, plus for each miss the latency of the
/// level that answers it, without overlap. `latencies_ns`: of this machine, for each level beyond the first,
/// memory last; they also replace the unknown latencies of other machines.
void predict(CacheCost& cost, std::span<const double> latencies_ns);

}  // namespace edgewise::studies::advise
