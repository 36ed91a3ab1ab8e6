// SPDX-License-Identifier: MIT
//
// The tetrahedron that EPA starts from: GJK's last simplex, rid of corners that add no dimension and grown by
// support points until it has volume. It need not hold the origin: a face that has the origin outside has a
// negative distance, and is expanded first.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>
#include <utility>

#include "edgewise/algorithms/penetration/difference.hpp"
#include "edgewise/algorithms/penetration/expansion.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise::epa {

class Tetrahedron {
  public:
    /// Starts from one to four corners.
    Tetrahedron(const Difference& difference, std::span<const Corner> given) : difference_(difference) {
        assert(!given.empty() && given.size() <= 4);
        choose_scale(given);
        for (const Corner& corner : given) {
            if (adds_dimension(corner)) push(corner);
        }
        while (count_ < 4 && grow()) continue;
        if (is_solid() && side(point_[0], point_[1], point_[2], point_[3]) > 0) {
            std::swap(point_[0], point_[1]);
            std::swap(corner_[0], corner_[1]);
        }
    }

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
    void choose_scale(std::span<const Corner> given) {
        double size = 0;
        for (const Corner& corner : given) size = std::max(size, corner.size());
        for (int i = 0; i < 6; ++i) {
            const Vec3d axis = (i < 3 ? 1 : -1) * Vec3d(Mat3d::Identity().col(i % 3));
            size = std::max(size, difference_.support(axis, given[0]).size());
        }
        scale_ = size > 0 ? std::ldexp(1.0, std::min(1000, -std::ilogb(size))) : 1;
    }

    [[nodiscard]] bool adds_dimension(const Corner& corner) const {
        const Vec3d w = corner.point(scale_);
        switch (count_) {
            case 0:
                return true;
            case 1:
                return w != point_[0];
            case 2:
                return max_abs(exact_cross(point_[0], point_[1], w)) > 0;
            default:
                return side(point_[0], point_[1], point_[2], w) != 0;
        }
    }

    void push(const Corner& corner) {
        assert(count_ < 4);
        corner_[count_] = corner;
        point_[count_] = corner.point(scale_);
        ++count_;
    }

    /// Adds the corner farthest across the points so far; false if there is none.
    bool grow() {
        double farthest = -1;
        Corner best = corner_[0];
        for (int i = 0; i < 4 - count_; ++i) {
            for (const double sign : {1.0, -1.0}) {
                const Vec3d direction = sign * across(i);
                const Corner corner = difference_.support(direction, corner_[0]);
                const double height = dot(direction, Vec3d(corner.point(scale_) - point_[0]));
                if (height <= farthest || !adds_dimension(corner)) continue;
                farthest = height;
                best = corner;
            }
        }
        if (farthest < 0) return false;
        push(best);
        return true;
    }

    /// Returns one of the 4 - count directions at right angles to the points so far.
    [[nodiscard]] Vec3d across(int i) const {
        if (count_ == 3) return triangle_normal(point_[0], point_[1], point_[2]);
        const Vec3d axis = Mat3d::Identity().col(i);
        if (count_ == 1) return axis;
        const Vec3d along = point_[1] - point_[0];
        int least = 0;
        along.cwiseAbs().minCoeff(&least);
        const Vec3d across_line = cross(along, Vec3d(Mat3d::Identity().col(least)));
        const Vec3d chosen = i == 0 ? across_line : cross(along, across_line);
        return chosen / norm(chosen);
    }

    const Difference& difference_;
    SmallArray<Corner, 4> corner_;
    SmallArray<Vec3d, 4> point_;
    int count_ = 0;
    double scale_ = 1;
};

}  // namespace edgewise::epa
