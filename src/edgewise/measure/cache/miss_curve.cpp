// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/miss_curve.hpp"

#include <cmath>
#include <numeric>

namespace edgewise::measure {

std::uint64_t MissCurve::misses(std::uint64_t lines) const {
    if (lines >= at_.size()) return firsts_;
    const auto from = at_.begin() + static_cast<std::ptrdiff_t>(lines);
    return std::accumulate(from, at_.end(), firsts_);
}

std::uint64_t MissCurve::smallest_size(double misses) const {
    std::uint64_t beyond = 0;  // uses at a distance of `lines` or more
    for (std::uint64_t lines = at_.size(); lines > 0; --lines) {
        beyond += at_[lines - 1];
        if (static_cast<double>(beyond) > misses) return lines;
    }
    return 0;
}

std::vector<MissCurve::Point> MissCurve::points(std::size_t points) const {
    std::vector<Point> all;
    std::uint64_t misses = uses_;
    for (std::uint64_t lines = 0; lines < at_.size(); ++lines) {
        if (lines > 0 && at_[lines - 1] != 0) all.push_back({lines, misses});
        misses -= at_[lines];
    }
    if (!at_.empty() && at_.back() != 0) all.push_back({at_.size(), misses});
    if (all.size() <= points || points < 2) return all;
    // The last point of each step of the logarithm says what a cache of that size misses.
    std::vector<Point> some;
    const double span = std::log(static_cast<double>(all.back().lines));
    const double steps = static_cast<double>(points - 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto step = [&](const Point& point) {
            return span > 0 ? std::floor(std::log(static_cast<double>(point.lines)) / span * steps) : 0;
        };
        if (i + 1 == all.size() || step(all[i]) != step(all[i + 1])) some.push_back(all[i]);
    }
    return some;
}

}  // namespace edgewise::measure
