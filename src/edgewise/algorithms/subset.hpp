// SPDX-License-Identifier: MIT
//
// Subsets of a simplex of at most four points, the point of one of them that is closest to the origin, and
// the two points, one of either body, that differ by it.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// Points of a simplex: the first of four places.
template <class Scalar>
using SimplexPoints = SmallArray<Vec3<Scalar>, 4>;

/// A subset of a simplex's points; bit i: point i belongs to it.
using PointMask = std::uint8_t;

/// Returns true for three points. (std::popcount may be a library call where the instruction is missing.)
[[nodiscard]] constexpr bool is_triangle(PointMask mask) {
    constexpr unsigned triangles = 1U << 7 | 1U << 11 | 1U << 13 | 1U << 14;
    return (triangles >> mask & 1U) != 0;
}

/// Returns true for two points.
[[nodiscard]] constexpr bool is_edge(PointMask mask) {
    constexpr unsigned edges = 1U << 3 | 1U << 5 | 1U << 6 | 1U << 9 | 1U << 10 | 1U << 12;
    return (edges >> mask & 1U) != 0;
}

/// Johnson's order, without the whole: smaller subsets first.
inline constexpr SmallArray<PointMask, 14> ascending_subsets = {1, 2,  4,  8, 3,  5,  6,
                                                                9, 10, 12, 7, 11, 13, 14};

[[nodiscard]] constexpr int lowest_point(PointMask mask) {
    assert(mask != 0);
    return std::countr_zero(mask);
}

/// A triangle by two of its sides, from one corner.
template <class Scalar>
struct TriangleSides {
    Vec3<Scalar> p, q;

    /// Returns true if it is too long and low for its foot to be as accurate as its corners.
    [[nodiscard]] bool is_thin() const {
        const Scalar longest = squared_side();
        return !(squared_norm(cross(p, q)) > Tolerance<Scalar>::thin * longest * longest);
    }

    /// The closest point to the origin, from the weighted sum of the corners: the sum itself, or its foot on
    /// the normal through the origin. Where the triangle is long and low (length over height k) the weights
    /// are off by k^2 rounding steps, the sum by k^2 times the length, and its direction, along which the
    /// next support point is sought, by that over its own length; the normal's direction is off by k steps.
    /// The more accurate one wins; for a sliver, with a normal that is noise, the sum, which at least is a
    /// point of the triangle.
    [[nodiscard]] Vec3<Scalar> foot(const Vec3<Scalar>& weighted) const {
        const Vec3<Scalar> normal = cross(p, q);
        const Scalar squared = squared_norm(normal), longest = squared_side();
        // Squared, as `longest` is: no product of more than four lengths.
        const Scalar height = squared / longest;
        const bool sliver = !(height > Tolerance<Scalar>::sliver * longest);
        if (sliver || height * squared_norm(weighted) >= longest * longest) return weighted;
        return (dot(normal, weighted) / squared) * normal;
    }

  private:
    /// Squared length of the longer side.
    [[nodiscard]] Scalar squared_side() const { return std::max(squared_norm(p), squared_norm(q)); }
};

/// Sides of the triangle that `mask` selects from the points.
template <class Scalar>
[[nodiscard]] TriangleSides<Scalar> triangle_sides(const SimplexPoints<Scalar>& w, PointMask mask) {
    assert(is_triangle(mask));
    const int i = lowest_point(mask);
    const int j = lowest_point(static_cast<PointMask>(mask & (mask - 1)));
    const int k = std::bit_width(mask) - 1;
    return {w[j] - w[i], w[k] - w[i]};
}

/// The subset that the closest point rests on, and that point.
template <class Scalar>
struct ClosestOfSimplex {
    PointMask members = 0;
    bool backup = false;  ///< no subset passed: the nearest of all subsets was taken
    bool thin = false;    ///< a triangle too long and low for `point` to be as good as its corners are
    SmallArray<Scalar, 4> weight{};  ///< of members; they sum to one
    Vec3<Scalar> point;

    /// Sets the subset, and the point from the weighted sum of its members.
    void rest_on(PointMask subset, const SimplexPoints<Scalar>& w, const Vec3<Scalar>& weighted) {
        members = subset;
        backup = false;
        thin = false;
        point = weighted;
        if (!is_triangle(subset)) return;
        const TriangleSides<Scalar> sides = triangle_sides(w, subset);
        thin = sides.is_thin();
        point = sides.foot(weighted);
    }
};

/// Weighted sums of a simplex's points on both bodies, in A's frame.
template <class Scalar>
struct WitnessPoints {
    Vec3<Scalar> on_a = Vec3<Scalar>::Zero(), on_b = Vec3<Scalar>::Zero();

    WitnessPoints() = default;
    /// Sums on_a(i) and on_b(i) of `count` points.
    template <class Points>
    WitnessPoints(const Points& simplex, const ClosestOfSimplex<Scalar>& closest) {
        for (int i = 0; i < simplex.count; ++i) {
            on_a += closest.weight[i] * simplex.on_a(i);
            on_b += closest.weight[i] * simplex.on_b(i);
        }
    }

    /// Returns true if they are as near to each other as the closest point is to the origin, except for
    /// the rounding of coordinates up to `size`. The foot on the plane of a triangle may lie outside the
    /// triangle.
    [[nodiscard]] bool are_as_near_as(Scalar distance, Scalar size) const {
        const Scalar most = distance + Tolerance<Scalar>::support_noise * size;
        return squared_norm(Vec3<Scalar>(on_a - on_b)) <= most * most;
    }

    /// Writes the answer for separated bodies. Weights on a thin triangle are less accurate than its foot,
    /// the closest point: the difference of the witness points from it is shared out, so that they are
    /// separated by the reported distance.
    void write_separated(const Vec3<Scalar>& closest, Scalar distance, Distance& answer) const {
        const Vec3<Scalar> excess = Scalar(0.5) * (on_a - on_b - closest);
        answer.status = Status::separated;
        answer.distance = distance;
        answer.point_a = cast<double>(Vec3<Scalar>(on_a - excess));
        answer.point_b = cast<double>(Vec3<Scalar>(on_b + excess));
        answer.normal = cast<double>(Vec3<Scalar>(closest * (-1 / distance)));
    }
};

}  // namespace edgewise
