// SPDX-License-Identifier: MIT
//
// Where a body must stand to be at a wanted distance from another.
//
// Along a ray through both centres the distance f(s) of convex bodies is convex, its slope at most 1. So s -
// (f - target) never passes the root, and neither does a secant through two points beyond it: the search
// comes down from far off, needs no bracket, and takes about five evaluations.
#pragma once

namespace edgewise::scene {

/// The place s on the ray where distance_at(s) is `target`, to a tolerance. `far`: a place where the bodies
/// surely are farther apart than that.
template <class DistanceAt>
[[nodiscard]] double find_offset(const DistanceAt& distance_at, double target, double far, double tolerance) {
    constexpr int most_evaluations = 40;
    double s = far;
    double excess = distance_at(s) - target;
    double slope = 1;
    for (int i = 1; i < most_evaluations && excess > tolerance; ++i) {
        const double next = s - excess / slope;
        const double next_excess = distance_at(next) - target;
        if (next_excess < -tolerance) break;  // a step too far, by rounding or by a wrong distance: keep s
        slope = (excess - next_excess) / (s - next);
        s = next;
        excess = next_excess;
        if (!(slope > 0)) break;  // the distance does not fall any more: only rounding is left
    }
    return s;
}

}  // namespace edgewise::scene
