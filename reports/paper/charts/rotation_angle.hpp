// SPDX-License-Identifier: MIT
//
// What a rotation between two steps amounts to. A rotation by w is the same orientation as one of w less
// whole turns, and one beyond half a turn is a smaller one in the opposite direction: coherence knows the
// folded angle only.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace edgewise::reports {

/// w mod 2 pi, then the smaller of that and the rest of the turn: 0 to pi.
[[nodiscard]] inline double folded_angle(double w) {
    constexpr double whole = 2 * std::numbers::pi;
    const double rest = std::fmod(std::abs(w), whole);
    return std::min(rest, whole - rest);
}

/// The mean angle between two random orientations: pi/2 + 2/pi, since the density of the angle t is
/// (1 - cos t) / pi.
inline constexpr double random_angle = std::numbers::pi / 2 + 2 / std::numbers::pi;

}  // namespace edgewise::reports
