// SPDX-License-Identifier: MIT
//
// A logarithmic axis of errors. An error of exactly 0 has no place on it, so it is drawn on a labelled floor,
// a whole power of ten that is a decade or more below the smallest error.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"

namespace edgewise::reports {

class ErrorAxis {
  public:
    /// Errors that it must show, in any order, none below 0; one at least.
    explicit ErrorAxis(std::vector<double> errors);

    /// Returns the place on the axis at which an error of 0 is drawn.
    [[nodiscard]] double floor() const { return floor_; }
    [[nodiscard]] bool has_zeros() const { return errors_.front() == 0; }
    [[nodiscard]] double place(double error) const { return error > 0 ? error : floor_; }
    /// Returns even powers of ten among the errors, and the floor if an error of 0 exists. A tick beyond the
    /// data would be drawn outside the panel.
    [[nodiscard]] ChartJson ticks() const;
    /// First and last place.
    [[nodiscard]] ChartJson domain() const;
    /// A Vega expression of a tick's label.
    [[nodiscard]] std::string tick_label() const;

  private:
    std::vector<double> errors_;  ///< in order
    double floor_ = 1e-15;
};

}  // namespace edgewise::reports
