// SPDX-License-Identifier: MIT
//
// How many processes and rounds of a race fit into a time, by what its parts took at the first look. More
// processes come before more rounds: an interval is between processes.
#pragma once

namespace edgewise::studies::advise {

/// Seconds.
struct RaceCost {
    double process = 0;  ///< of each process, before its rounds: bodies and tables made, answers checked
    double round = 0;    ///< every cell timed once
    double traces = 0;   ///< lines and caches, of the processes that trace
};

struct RacePlan {
    int processes = 3, rounds = 25;
};

inline constexpr RacePlan whole_race{}, least_race{1, 5};

/// Seconds that it is expected to take. The first process does its part twice: for the case, and for a few
/// bodies that fit the cache.
[[nodiscard]] double race_seconds(const RaceCost& cost, const RacePlan& plan);

/// The largest race that is expected to end in so many seconds; the least one where none is.
[[nodiscard]] RacePlan race_within(double seconds, const RaceCost& cost);

}  // namespace edgewise::studies::advise
