// SPDX-License-Identifier: MIT
//
// A logarithmic axis of a picture drawn by hand: values to pixels, and the round values between its ends.
#pragma once

#include <vector>

namespace edgewise::reports {

/// Values outside the ends are drawn at the ends.
class LogScale {
  public:
    /// 0 < low < high; pixels may run downwards.
    LogScale(double low, double high, double first_pixel, double last_pixel);

    [[nodiscard]] double place(double value) const;
    /// 1, 2 and 5 times powers of ten within the ends; of a wide axis powers of ten alone.
    [[nodiscard]] std::vector<double> ticks() const;

  private:
    double low_, high_, first_, last_;
};

}  // namespace edgewise::reports
