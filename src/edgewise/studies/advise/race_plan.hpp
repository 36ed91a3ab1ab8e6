// SPDX-License-Identifier: MIT
//
// How many processes and rounds of a race fit into a time, given how long its parts took in the first look.
// More processes come before more rounds, because an interval is between processes.
#pragma once

#include <functional>
#include <optional>
#include <utility>

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

}  // namespace edgewise::studies::advise
