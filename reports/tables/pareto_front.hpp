// SPDX-License-Identifier: MIT
//
// Which points of a cloud of times and errors are worth choosing: those that nothing beats in both. A point
// is dominated by one that is no worse in either and better in one, so equal points stand or fall together.
#pragma once

#include <span>
#include <vector>

namespace edgewise::reports {

/// Smaller is better in both; infinity is a number, NaN none.
struct SpeedError {
    double ns, error;
};

/// For each point, whether none dominates it. A point with a NaN is on no front and dominates nothing.
[[nodiscard]] std::vector<bool> pareto_front(std::span<const SpeedError> points);

}  // namespace edgewise::reports
