// SPDX-License-Identifier: MIT
//
// Axis-aligned boxes: of point sets, and as the broad phase takes them.
#pragma once

#include <cassert>
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

}  // namespace edgewise
