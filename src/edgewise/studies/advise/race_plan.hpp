// SPDX-License-Identifier: MIT
//
// How many processes and rounds of a race fit into a time, given how long its parts took in the first look.
// More processes come before more rounds, because an interval is between processes.
#pragma once

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

}  // namespace edgewise::studies::advise
