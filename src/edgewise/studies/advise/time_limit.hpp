// SPDX-License-Identifier: MIT
//
// A limit of time for work in pieces that cannot be left half-way: a piece is begun only where one as long as
// the longest so far would end in time.
#pragma once

#include <functional>
#include <optional>
#include <utility>

namespace edgewise::studies::advise {

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
