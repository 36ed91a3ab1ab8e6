// SPDX-License-Identifier: MIT
#include "edgewise/reports/charts/error_axis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace edgewise::reports {

ErrorAxis::ErrorAxis(std::vector<double> errors) : errors_(std::move(errors)) {
    assert(!errors_.empty());
    std::sort(errors_.begin(), errors_.end());
    const auto positive = std::upper_bound(errors_.begin(), errors_.end(), 0.0);
    const double least = positive == errors_.end() ? 1e-15 : std::min(1e-15, *positive);
    while (floor_ > least / 10 && floor_ > 1e-300) floor_ /= 10;
}

ChartJson ErrorAxis::ticks() const {
    ChartJson places = ChartJson::array();
    if (has_zeros()) places.push_back(floor_);
    const double first = has_zeros() ? 10 * floor_ : errors_.front();
    for (int power = -300; power <= 300; power += 2) {
        // Read from text: a product of tens would miss the decimal value by a rounding.
        const double place = std::stod(fmt::format("1e{}", power));
        if (place >= first && place <= errors_.back()) places.push_back(place);
    }
    return places;
}

ChartJson ErrorAxis::domain() const { return {place(errors_.front()), place(errors_.back())}; }

std::string ErrorAxis::tick_label() const {
    return fmt::format("datum.value < {:g} ? 'exactly 0' : format(datum.value, '.0e')", floor_ * 2);
}

}  // namespace edgewise::reports
