// SPDX-License-Identifier: MIT
//
// The tetrahedron that EPA starts from: GJK's last simplex, rid of corners that add no dimension and grown by
// support points until it has volume. It need not hold the origin: a face that has the origin outside has a
// negative distance, and is expanded first.
#pragma once

#include <span>

#include "edgewise/algorithms/penetration/difference.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise::epa {

class Tetrahedron {
  public:
    /// Starts from one to four corners.
    Tetrahedron(const Difference& difference, std::span<const Corner> given);

    /// False if the whole difference is flat to within the precision of its points.
    [[nodiscard]] bool is_solid() const { return count_ == 4; }
    [[nodiscard]] int count() const { return count_; }

    /// Corners; the fourth point is below the triangle of the first three.
    [[nodiscard]] const SmallArray<Vec3d, 4>& points() const { return point_; }
    [[nodiscard]] const SmallArray<Corner, 4>& corners() const { return corner_; }

    /// Power of two that brings the bodies to a size of about 1 (within some 2^100, which exact products
    /// allow). Points are multiplied by it.
    [[nodiscard]] double scale() const { return scale_; }

    /// A unit direction normal to the points, for a difference that is flat.
    [[nodiscard]] Vec3d across() const { return across(0); }

  private:
    /// The start may lie near both bodies' origin and not show their size, so the box is used too.
    void choose_scale(std::span<const Corner> given);
    [[nodiscard]] bool adds_dimension(const Corner& corner) const;
    void push(const Corner& corner);
    /// Adds the corner farthest across the points so far; false if there is none.
    bool grow();
    /// Returns one of the 4 - count directions at right angles to the points so far.
    [[nodiscard]] Vec3d across(int i) const;

    const Difference& difference_;
    SmallArray<Corner, 4> corner_;
    SmallArray<Vec3d, 4> point_;
    int count_ = 0;
    double scale_ = 1;
};

}  // namespace edgewise::epa
