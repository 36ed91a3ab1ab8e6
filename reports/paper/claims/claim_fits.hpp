// SPDX-License-Identifier: MIT
//
// How a quantity grows: the exponent of a power law through a curve, and whether a logarithm fits it better.
#pragma once

#include <vector>

#include "edgewise/reports/paper/claims/claim_cells.hpp"

namespace edgewise::reports {

/// The slope of log y over log x by least squares. Its interval is what the slope can be while every y stays
/// within its own interval. None with fewer than three points above 0, for which a slope has no test.
[[nodiscard]] Evidence growth_exponent(const std::vector<CurvePoint>& curve);

/// Root mean squares of the relative residuals of a + b log x and of c x^p, each fitted to make its own
/// small.
struct LogOrPower {
    Evidence logarithm, power;
};
[[nodiscard]] LogOrPower log_or_power(const std::vector<CurvePoint>& curve);

}  // namespace edgewise::reports
