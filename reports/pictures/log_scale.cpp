// SPDX-License-Identifier: MIT
#include "edgewise/reports/pictures/log_scale.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace edgewise::reports {

namespace {

constexpr double decades_with_all_ticks = 2.5;

}  // namespace

LogScale::LogScale(double low, double high, double first_pixel, double last_pixel)
    : low_(low), high_(high), first_(first_pixel), last_(last_pixel) {
    assert(low > 0 && low < high);
}

double LogScale::place(double value) const {
    const double part = std::log(std::clamp(value, low_, high_) / low_) / std::log(high_ / low_);
    return first_ + part * (last_ - first_);
}

std::vector<double> LogScale::ticks() const {
    std::vector<double> all;
    const bool wide = std::log10(high_ / low_) > decades_with_all_ticks;
    for (int power = static_cast<int>(std::floor(std::log10(low_))); power <= std::log10(high_); ++power)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double tick = digit * std::pow(10.0, power);
            if ((digit == 1 || !wide) && tick >= low_ && tick <= high_) all.push_back(tick);
        }
    return all;
}

}  // namespace edgewise::reports
