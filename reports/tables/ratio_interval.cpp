// SPDX-License-Identifier: MIT
//
// The k-th smallest and k-th largest of n values enclose the median with probability
// 1 - 2 P(B < k), B binomial(n, 1/2) (David and Nagaraja, Order Statistics, 7.1).
#include "edgewise/reports/tables/ratio_interval.hpp"

#include <algorithm>
#include <cmath>

namespace edgewise::reports {

namespace {

/// The largest k with P(B < k) <= 2.5 %; 0 when there is none.
std::size_t trimmed_each_side(std::size_t n) {
    // 2^-n underflows past 1074; beyond 1000 rounds the k of 1000 gives an interval wider than need be, never
    // narrower.
    const std::size_t count = std::min<std::size_t>(n, 1000);
    double term = std::ldexp(1.0, -static_cast<int>(count)), below = 0;
    for (std::size_t k = 0; k < count; ++k) {
        below += term;
        if (below > 0.025) return k;
        term *= static_cast<double>(count - k) / static_cast<double>(k + 1);
    }
    return 0;
}

}  // namespace

std::optional<RatioInterval> median_interval(std::vector<double> ratios) {
    if (ratios.size() < 2) return std::nullopt;
    std::ranges::sort(ratios);
    const std::size_t k = trimmed_each_side(ratios.size());
    if (k == 0) return RatioInterval{ratios.front(), ratios.back(), true};
    return RatioInterval{ratios[k - 1], ratios[ratios.size() - k], false};
}

}  // namespace edgewise::reports
