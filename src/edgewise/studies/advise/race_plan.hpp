// SPDX-License-Identifier: MIT
//
// How many processes and rounds of a race fit into a time, given how long its parts took in the first look.
// More processes come before more rounds, because an interval is between processes.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"

namespace edgewise::studies::advise {

/// Durations of the parts of a race, in seconds.
struct RaceCost {
    double process = 0;  ///< of each process, before its rounds: bodies and tables made, answers checked
    double round = 0;    ///< every cell timed once
    double traces = 0;   ///< lines and caches, of the processes that trace
};

struct RacePlan {
    int processes = 3, rounds = 25;
};

inline constexpr RacePlan whole_race{}, least_race{1, 5};

/// Returns the seconds that the race is expected to take. The first process does its part twice: for the
/// case, and for a few bodies that fit the cache.
[[nodiscard]] double race_seconds(const RaceCost& cost, const RacePlan& plan);

/// Returns the largest race that is expected to end within `seconds`; the smallest race if none is.
[[nodiscard]] RacePlan race_within(double seconds, const RaceCost& cost);

// A limit of time for work in pieces that cannot be left half-way: a piece is begun only where one as long as
// the longest so far would end in time.

class TimeLimit {
  public:
    /// `clock`: seconds since any moment; `end`: when it has to be over, by that clock.
    TimeLimit(std::function<double()> clock, double end) : clock_(std::move(clock)), end_(end) {}

    /// Call it before each piece, which lasts until the next call. Returns true if there is time for one.
    [[nodiscard]] bool begin_piece();

    /// Returns the seconds left; negative after the end.
    [[nodiscard]] double left() const { return end_ - clock_(); }

  private:
    std::function<double()> clock_;
    double end_, longest_ = 0;
    std::optional<double> begun_;  ///< the piece in hand
};

// Predicts the time of a query from its modelled misses, to be shown next to the measured time.

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
