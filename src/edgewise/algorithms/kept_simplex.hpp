// SPDX-License-Identifier: MIT
//
// Up to three pairs of vertices that may hold the closest points of two bodies, and the proof that they do.
// They are what a pair keeps of its last query, or corners of V-Clip's features. Most coherent queries end
// where they start, and this takes less than the first iteration of a search.
//
// The proof has two sides (duality gap: Boyd, Vandenberghe, Convex Optimization, 2004, 5.5.1). From below: no
// vertex of the Minkowski difference lies nearer to the origin along the closest point's direction. From
// above: weights that are not negative make a point that is as near; the foot on a sliver's plane may lie
// outside the sliver.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>
#include <utility>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/simplex_pair.hpp"
#include "edgewise/algorithms/subset.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// Number: computes; it may be wider than the tables' scalar. Tables and pose must live longer.
template <SupportTable TableA, SupportTable TableB, class Number>
class KeptSimplex {
  public:
    using Scalar = ComputeOf<TableA>;

    int count = 0;

    KeptSimplex(const TableA& a, const TableB& b, const Transform<Scalar>& a_from_b)
        : a_(a), b_(b), a_from_b_(in_scalar<Number>(a_from_b)) {}

    /// Points of A and B, both in A's frame.
    [[nodiscard]] const Vec3<Number>& on_a(int i) const { return on_a_[i]; }
    [[nodiscard]] const Vec3<Number>& on_b(int i) const { return on_b_[i]; }
    /// The point that rests_on_all() computed; its weights are those of the points.
    [[nodiscard]] const ClosestOfSimplex<Number>& closest() const { return closest_; }
    /// Least weight of the points; less than 0 where the closest point lies outside the simplex.
    [[nodiscard]] Number least_weight() const {
        Number least = 1;
        for (int i = 0; i < count; ++i) least = std::min(least, closest_.weight[i]);
        return least;
    }
    [[nodiscard]] Number squared_distance() const { return squared_norm(closest_.point); }
    /// Longest coordinate of the points: rounding is relative to it.
    [[nodiscard]] Number size() const { return size_; }

    void clear() { count = 0; }
    void push(typename TableA::Vertex a, typename TableB::Vertex b) {
        assert(count < 3);
        if (count == 0) first_ = {a, b};
        on_a_[count] = cast<Number>(a_.vertex(a));
        on_b_[count] = a_from_b_.point(cast<Number>(b_.vertex(b)));
        difference_[count] = on_a_[count] - on_b_[count];
        size_ = std::max({size_, max_abs(on_a_[count]), max_abs(on_b_[count])});
        ++count;
    }

    /// Computes the closest point of the simplex, if it rests on all its points: they are not nearly on a
    /// line, and no weight is negative.
    [[nodiscard]] bool rests_on_all() {
        closest_.members = static_cast<PointMask>((1 << count) - 1);
        if (count == 3) return rests_on_triangle();
        if (count == 2) return rests_on_edge();
        closest_.weight[0] = 1;
        closest_.point = difference_[0];
        return count == 1;
    }

    /// Returns true if closest() is the bodies' closest point to the precision of Number, or lies within the
    /// contact tolerance. False where nothing is proven: a search goes on.
    [[nodiscard]] bool is_proven(const QueryOptions& options) {
        const Number squared = squared_distance();
        distance_ = std::sqrt(squared);
        witnesses_ = {*this, closest_};
        const bool is_clear = distance_ > Tolerance<Number>::hardly_close * size_;
        if (!is_clear || !witnesses_.are_as_near_as(distance_, size_)) return false;
        if (distance_ <= static_cast<Number>(options.contact_tolerance)) return true;
        const Number open = std::max(Tolerance<Number>::open_gap * size_,
                                     static_cast<Number>(options.gap_tolerance) * distance_);
        return squared - reach(closest_.point) <= open * distance_;
    }

    /// Writes distance, normal and witness points after is_proven() has returned true; counts stay.
    void write(Distance& answer) const { witnesses_.write_separated(closest_.point, distance_, answer); }

    /// The closest point of the line or plane of the points, times a positive number: it takes no division.
    [[nodiscard]] Vec3<Number> direction() const {
        assert(count > 0);
        if (count == 1) return difference_[0];
        const Vec3<Number> edge = difference_[1] - difference_[0];
        if (count == 2) return squared_norm(edge) * difference_[0] - dot(difference_[0], edge) * edge;
        const Vec3<Number> normal = cross(edge, Vec3<Number>(difference_[2] - difference_[0]));
        return dot(normal, difference_[0]) < 0 ? Vec3<Number>(-normal) : normal;
    }

    /// Returns true if the bodies are farther from each other than `cutoff` along v, towards A.
    [[nodiscard]] bool is_beyond(Number cutoff, const Vec3<Number>& v) const {
        return reach(v) > (cutoff + Tolerance<Number>::support_noise * size_) * norm(v);
    }

    /// The answer for bodies that v separates: its distance, of two of their points, is an upper bound.
    [[nodiscard]] Distance answer_beyond(const Vec3<Number>& v) const {
        Distance answer = between(on_a_[0], on_b_[0]);
        answer.normal = cast<double>(Vec3<Number>(v * (-1 / norm(v))));
        return answer;
    }

  private:
    [[nodiscard]] bool rests_on_edge() {
        const Vec3<Number> edge = difference_[1] - difference_[0];
        const Number inverse = 1 / squared_norm(edge), t = -dot(difference_[0], edge) * inverse;
        const Vec3<Number> foot = difference_[0] + t * edge;
        // The rounding of t, along the edge, would be a large part of a short distance.
        closest_.point = foot - (dot(foot, edge) * inverse) * edge;
        closest_.weight[0] = 1 - t;
        closest_.weight[1] = t;
        return t >= 0 && t <= 1;
    }

    [[nodiscard]] bool rests_on_triangle() {
        const TriangleSides<Number> sides{difference_[1] - difference_[0], difference_[2] - difference_[0]};
        const Vec3<Number> normal = cross(sides.p, sides.q), across = cross(normal, difference_[0]);
        const Number inverse = 1 / squared_norm(normal);
        const Number p = -dot(across, sides.q) * inverse, q = dot(across, sides.p) * inverse;
        closest_.point = (dot(normal, difference_[0]) * inverse) * normal;
        closest_.weight[0] = 1 - p - q;
        closest_.weight[1] = p;
        closest_.weight[2] = q;
        return p >= 0 && q >= 0 && p + q <= 1 && !sides.is_thin();
    }

    /// The least <v, w> of all points w of the difference.
    [[nodiscard]] Number reach(const Vec3<Number>& v) const {
        const Number of_a = greatest_height(a_, Vec3<Number>(-v), first_.a);
        const Number of_b = greatest_height(b_, a_from_b_.direction_back(v), first_.b);
        return -(of_a + of_b) - dot(v, a_from_b_.translation);
    }

    const TableA& a_;
    const TableB& b_;
    decltype(in_scalar<Number>(std::declval<const Transform<Scalar>&>())) a_from_b_;
    VertexPair<TableA, TableB> first_;
    SmallArray<Vec3<Number>, 3> on_a_, on_b_, difference_;
    ClosestOfSimplex<Number> closest_;
    WitnessPoints<Number> witnesses_;  ///< of the last is_proven(), as is distance_
    Number distance_ = 0;
    Number size_ = 0;
};

/// Calls ask(simplex) with an empty simplex, and returns what it does. Small bodies are computed in doubles,
/// in which close ones can be proven too; large ones in their own scalar, in which climbs find heights.
template <SupportTable TableA, SupportTable TableB, class Ask>
[[nodiscard]] bool ask_kept_simplex(const TableA& a, const TableB& b,
                                    const Transform<ComputeOf<TableA>>& a_from_b, const Ask& ask) {
    using Scalar = ComputeOf<TableA>;
    if constexpr (!std::is_same_v<Scalar, double>) {
        if (!is_small(a) || !is_small(b)) {
            KeptSimplex<TableA, TableB, Scalar> kept(a, b, a_from_b);
            return ask(kept);
        }
    }
    KeptSimplex<TableA, TableB, double> kept(a, b, a_from_b);
    return ask(kept);
}

}  // namespace edgewise
