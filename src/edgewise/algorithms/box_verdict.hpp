// SPDX-License-Identifier: MIT
//
// The verdict on two boxes by separating axes: they are apart if and only if their shadows are on one of 15
// directions, the normals of their faces and those across an edge of each (Gottschalk, Lin, Manocha 1996).
// The directions that most often separate come first. Departure: a direction across two edges is judged in
// its own length, so that nearly parallel edges decide as exactly as others; the source adds a constant to
// the rotation instead, and says "overlapping" of boxes that such a direction separates.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/geometry/pack.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// A table whose body is a box about the origin with its sides along the axes.
template <class T>
concept BoxTable = SupportTable<T> && requires(const T& table) {
    { table.half_extents() } -> std::convertible_to<Vec3d>;
};

/// Two boxes in A's frame. Keeps a reference to the pose.
class BoxAxes {
  public:
    BoxAxes(const Vec3d& half_a, const Vec3d& half_b, const Transform<double>& a_from_b)
        : a_(half_a), b_(half_b), r_(a_from_b.rotation), t_(a_from_b.translation) {}

    /// Finds a direction along which the boxes are farther apart than `gap`, by more than rounding; `axis`
    /// points from A to B and is not a unit vector.
    [[nodiscard]] bool separate(double gap, Vec3d& axis) const {
        const double sizes = sum_of_magnitudes(t_) + sum_of_magnitudes(a_) + sum_of_magnitudes(b_);
        const double least = gap + box_axis_rounding * sizes;
        return by_face_of_a(least, axis) || by_face_of_b(least, axis) || by_edges(least, axis);
    }

  private:
    using Four = Pack<double, 32>;
    using Numbers = Four::Numbers;

    // Component by component: a whole vector would wait for its way through memory.

    [[nodiscard]] static double sum_of_magnitudes(const Vec3d& v) {
        return std::abs(v.x()) + std::abs(v.y()) + std::abs(v.z());
    }

    [[nodiscard]] bool by_face_of_a(double least, Vec3d& axis) const {
        for (int i = 0; i < 3; ++i) {
            const double reach_b =
                std::abs(r_(i, 0)) * b_[0] + std::abs(r_(i, 1)) * b_[1] + std::abs(r_(i, 2)) * b_[2];
            if (!(std::abs(t_[i]) - a_[i] - reach_b > least)) continue;
            axis = Vec3d::Zero();
            axis[i] = t_[i];
            return true;
        }
        return false;
    }

    [[nodiscard]] bool by_face_of_b(double least, Vec3d& axis) const {
        for (int j = 0; j < 3; ++j) {
            const double along = t_[0] * r_(0, j) + t_[1] * r_(1, j) + t_[2] * r_(2, j);
            const double reach_a =
                std::abs(r_(0, j)) * a_[0] + std::abs(r_(1, j)) * a_[1] + std::abs(r_(2, j)) * a_[2];
            if (!(std::abs(along) - b_[j] - reach_a > least)) continue;
            axis = along * r_.col(j);
            return true;
        }
        return false;
    }

    /// Across edge i of A and each edge of B, a lane each. Such a direction has no part along i, and all sums
    /// are of products of its two other parts: as exact as these, however short it is.
    [[nodiscard]] bool by_edges(double least, Vec3d& axis) const {
        const Numbers b_next = {b_[1], b_[2], b_[0]}, b_last = {b_[2], b_[0], b_[1]};
        for (int i = 0; i < 3; ++i) {
            const int p = (i + 1) % 3, q = (i + 2) % 3;
            const Numbers row_p = {r_(p, 0), r_(p, 1), r_(p, 2)}, row_q = {r_(q, 0), r_(q, 1), r_(q, 2)};
            Numbers part_p, part_q, next_p, next_q, last_p, last_q, across, across_next, across_last, apart;
            turn(row_p, next_p, last_p);
            turn(row_q, next_q, last_q);
            magnitude(next_p * last_q - last_p * next_q, across);
            turn(across, across_next, across_last);
            magnitude(row_p, part_p);
            magnitude(row_q, part_q);
            const Numbers along = t_[q] * row_p - t_[p] * row_q;
            magnitude(along, apart);
            apart -= a_[p] * part_q + a_[q] * part_p + b_next * across_last + b_last * across_next;
            apart -= least * (part_p + part_q);
            if (!(std::max({apart[0], apart[1], apart[2]}) > 0)) continue;
            const int j = apart[2] > 0 ? 2 : int{apart[1] > 0};
            axis[i] = 0;
            axis[p] = -along[j] * row_q[j];
            axis[q] = along[j] * row_p[j];
            return true;
        }
        return false;
    }

    /// The numbers of the next lane, and of the one after it, of three.
    [[gnu::always_inline]] static void turn(const Numbers& of, Numbers& next, Numbers& last) {
        next = __builtin_shufflevector(of, of, 1, 2, 0, 3);
        last = __builtin_shufflevector(of, of, 2, 0, 1, 3);
    }
    [[gnu::always_inline]] static void magnitude(const Numbers& of, Numbers& to) {
        to = reinterpret_cast<Numbers>(reinterpret_cast<Four::Words>(of) & ~(std::int64_t{1} << 63));
    }

    Vec3d a_, b_;  ///< half extents
    const Mat3d& r_;
    const Vec3d& t_;
};

/// Answers for the verdict alone; false where the boxes are apart by no more than the contact tolerance along
/// every axis: then their distance decides. The distance of separated boxes is that of their centres, an
/// upper bound.
template <BoxTable TableA, BoxTable TableB>
[[nodiscard]] [[gnu::noinline]] bool answer_boxes(const TableA& a, const TableB& b,
                                                  const Transform<double>& a_from_b, double contact_tolerance,
                                                  Distance& answer) {
    const BoxAxes boxes(a.half_extents(), b.half_extents(), a_from_b);
    Vec3d axis;
    answer.steps = 1;
    if (boxes.separate(contact_tolerance, axis)) {
        answer.status = Status::separated;
        answer.point_b = a_from_b.translation;
        answer.distance = norm(answer.point_b);
        answer.normal = axis * (1 / norm(axis));
        return true;
    }
    answer.status = Status::overlapping;
    return contact_tolerance == 0 || !boxes.separate(0, axis);
}

}  // namespace edgewise
