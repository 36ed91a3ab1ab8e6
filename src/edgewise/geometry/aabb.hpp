// SPDX-License-Identifier: MIT
//
// Axis-aligned boxes, as the broad phase takes them.
#pragma once

#include <cassert>

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

    /// Larger by `margin` on all six sides.
    [[nodiscard]] Aabb enlarged(double margin) const {
        assert(margin >= 0);
        return {(low.array() - margin).matrix(), (high.array() + margin).matrix()};
    }
};

}  // namespace edgewise
