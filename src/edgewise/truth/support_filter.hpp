// SPDX-License-Identifier: MIT
//
// Which vertices can be the lowest along a direction? A scan in double that never loses the true one.
//
// A body's own extreme vertex does not depend on where the body is, so the filter works on R (v - v0): a
// far-off origin, in the pose or in the vertices, costs it no digits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/truth/integer_vector.hpp"

namespace edgewise::truth {

class SupportFilter {
  public:
    SupportFilter(std::span<const Vec3d> vertices, const Mat3d& rotation);

    /// False if the coordinates overflowed: then every vertex is a candidate.
    [[nodiscard]] bool usable() const { return usable_; }

    /// R (v - v0) of a vertex, divided by 2^exponent(): entries below 12.
    [[nodiscard]] Vec3d shape(std::uint32_t i) const { return {x_[i], y_[i], z_[i]}; }
    [[nodiscard]] int exponent() const { return exponent_; }

    /// The vertex that looks lowest along the direction; ties go to the first.
    [[nodiscard]] std::uint32_t lowest(const Vec3d& direction);

    /// Returns every vertex that can be exactly lowest along a direction with entries of at most 1, known to
    /// 2^-52 (see rounded_direction). Valid until the next call.
    [[nodiscard]] std::span<const std::uint32_t> candidates(const Vec3d& direction);

  private:
    void scan(const Vec3d& direction);

    std::vector<double> x_, y_, z_;
    std::vector<double> heights_;
    std::vector<std::uint32_t> candidates_;
    int exponent_ = 0;
    bool usable_ = true;
};

/// The direction scaled by a power of two so that its largest entry is in [0.5, 1), truncated to double.
[[nodiscard]] Vec3d rounded_direction(const IntegerVec& direction);

}  // namespace edgewise::truth
