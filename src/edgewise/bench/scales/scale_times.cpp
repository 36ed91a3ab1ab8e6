// SPDX-License-Identifier: MIT
#include "edgewise/bench/scales/scale_times.hpp"

#include <cmath>

namespace edgewise::bench {

Transform<double> turned_place(const Transform<double>& place, std::size_t step) {
    const double angle = 0.1 * static_cast<double>(step), c = std::sqrt(1 - angle * angle / 16);
    Mat3d turn;
    turn << c, -angle / 4, 0, angle / 4, c, 0, 0, 0, 1;
    return {multiply(turn, place.rotation), place.translation};
}

}  // namespace edgewise::bench
