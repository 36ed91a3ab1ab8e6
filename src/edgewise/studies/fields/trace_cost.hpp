// SPDX-License-Identifier: MIT
//
// Cost of a trace: distinct lines of tables per query, and the modelled misses of several machines in
// their steady state. Traces of tables that were built and of predicted tables are counted in the same
// way.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::studies {

/// Misses of a level, per query of all queries.
struct LevelMissesPerQuery {
    std::string machine, level;
    double misses = 0;
};

struct TraceCost {
    std::uint64_t queries = 0, lines = 0, reads = 0;  ///< sums, of tables
    std::vector<LevelMissesPerQuery> misses;

    [[nodiscard]] double lines_per_query() const { return per_query(lines); }
    [[nodiscard]] double reads_per_query() const { return per_query(reads); }

  private:
    [[nodiscard]] double per_query(std::uint64_t sum) const {
        return queries == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(queries);
    }
};

/// A pass over all queries of a trace, as often as it is called.
using TracePass = std::function<void(measure::TraceListener& listener)>;

/// Runs two passes: the first fills caches and counts lines, the second counts misses.
[[nodiscard]] TraceCost cost_of(const TracePass& pass, std::span<const measure::CacheMachine> machines);

}  // namespace edgewise::studies
