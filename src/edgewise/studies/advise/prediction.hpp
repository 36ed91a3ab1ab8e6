// SPDX-License-Identifier: MIT
//
// What a query should take by the misses that were modelled, beside what was measured.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgewise::studies::advise {

/// This machine among those whose caches are modelled.
inline constexpr const char* this_machine = "host";

/// What caches cost one cell.
struct CacheCost {
    std::optional<double> in_cache_ns;  ///< per query, few bodies with one table; null: no time was left
    /// Modelled misses per query, by machine, level by level from the first on.
    std::map<std::string, std::vector<double>> misses;
    std::map<std::string, double> predicted_ns;  ///< per query, by machine
};

/// For each machine with modelled misses: the time in cache, and each miss as long as the level takes that
/// answers it, nothing overlapping. `latencies_ns`: here, of each level beyond the first, memory last; those
/// of a machine's own levels are not known, and these stand in for them.
void predict(CacheCost& cost, std::span<const double> latencies_ns);

}  // namespace edgewise::studies::advise
