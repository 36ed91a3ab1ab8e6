// SPDX-License-Identifier: MIT
//
// Broad phase: which axis-aligned boxes overlap. Sort and sweep (Baraff 1992; Cohen, Lin, Manocha, Ponamgi
// 1995).
//
// The boxes' low ends are kept sorted on all three axes from frame to frame; insertion sort repairs the order
// in linear time while motion is coherent. The sweep runs along the axis on which the boxes spread most and
// tests the other two directly. Departs from I-COLLIDE, which sweeps all three axes and keeps overlap
// counters a pair: that costs memory for every pair, where this costs a few comparisons for every near pair.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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
        return {(low.array() - margin).matrix(), (high.array() + margin).matrix()};
    }
};

struct BodyPair {
    std::uint32_t first, second;  ///< first < second

    [[nodiscard]] auto operator<=>(const BodyPair&) const = default;
};

class SweepAndPrune {
  public:
    explicit SweepAndPrune(std::size_t body_count);

    /// The overlapping pairs of one frame, sorted; valid until the next call. One box a body, none with NaN.
    [[nodiscard]] std::span<const BodyPair> update(std::span<const Aabb> boxes);

    /// Places that insertion sort moved in the last update, over all axes: the cost of lost coherence.
    [[nodiscard]] std::size_t moves() const { return moves_; }

  private:
    void sort_axis(int axis, std::span<const Aabb> boxes);
    void sweep_axis(int axis, std::span<const Aabb> boxes);

    std::array<std::vector<std::uint32_t>, 3> order_;  ///< bodies by low end, per axis
    std::vector<BodyPair> pairs_;
    std::size_t moves_ = 0;
};

}  // namespace edgewise
