// SPDX-License-Identifier: MIT
//
// The interval of a median ratio over rounds or processes, by order statistics: no distribution is assumed
// and no random number drawn, so the same store gives the same report. With fewer than six ratios the whole
// range holds the median with less than 95 %; the interval then is that range and says so.
#pragma once

#include <optional>
#include <vector>

namespace edgewise::reports {

struct RatioInterval {
    double low = 0, high = 0;
    bool whole_range = false;  ///< too few ratios for 95 %
};

/// Null when there are fewer than two ratios.
[[nodiscard]] std::optional<RatioInterval> median_interval(std::vector<double> ratios);

}  // namespace edgewise::reports
