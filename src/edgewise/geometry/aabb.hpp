// SPDX-License-Identifier: MIT
//
// Bounds of point sets: axis-aligned boxes, as the broad phase takes them, and radii about the origin.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "edgewise/geometry/vec.hpp"

namespace edgewise {

/// Closed axis-aligned box: boxes that touch overlap.
struct Aabb {
    Vec3d low, high;

    [[nodiscard]] bool overlaps(const Aabb& other) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (low[axis] > other.high[axis] || other.low[axis] > high[axis]) return false;
        }
        return true;
    }

    [[nodiscard]] Vec3d sides() const { return high - low; }

    void include(const Vec3d& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }

    /// Larger by `margin` on all six sides.
    [[nodiscard]] Aabb enlarged(double margin) const {
        assert(margin >= 0);
        return {(low.array() - margin).matrix(), (high.array() + margin).matrix()};
    }
};

/// The least box around the points; all zero without any.
[[nodiscard]] inline Aabb box_of(std::span<const Vec3d> points) {
    if (points.empty()) return {Vec3d::Zero(), Vec3d::Zero()};
    Aabb box{points.front(), points.front()};
    for (const Vec3d& point : points) box.include(point);
    return box;
}

/// Largest distance of a point from the origin, rounded upwards; 0 without points.
[[nodiscard]] inline double radius_of(std::span<const Vec3d> points) {
    double squared = 0;
    for (const Vec3d& point : points) squared = std::max(squared, squared_norm(point));
    return std::sqrt(squared) * (1 + 8 * std::numeric_limits<double>::epsilon());
}

/// The radii of two bodies, each about its own origin.
struct Radii {
    double a = 0, b = 0;
};

}  // namespace edgewise
