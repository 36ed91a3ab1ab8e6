// SPDX-License-Identifier: MIT
//
// Where a run of GJK starts. A warm query starts from the vertices of the pair's last simplex (Cameron 1997),
// a cold one at the points that face each other along the line of the origins. Departure: a last simplex that
// now lies much farther off, or that the first support points show to be useless, is given up for these
// points.
#pragma once

#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/simplex_pair.hpp"
#include "edgewise/algorithms/sub_distance.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// Share of the squared distance: a last simplex with a closest point that promises no more than this is far
/// off. It affects time, not right answers; so do the next constants.
inline constexpr double far_off_simplex = 0.5;

/// A last simplex that lies farther from the origin than this times its last distance and this part of its
/// longest coordinate is far off before any support point is asked for. Time relative to running without this
/// rule, pairs that turn in their places, 1 rad per step / to any pose, a Zen 3 with other load:
/// points_soa_f64 0.94 / 0.88 at 8 vertices, 0.89 / 0.87 at 38; lean_seeds_f64 0.65 / 0.60 at 386, 0.58 /
/// 0.52 at 1538. None counted as far off at 0.1 rad and less. 0.1 to 0.3 of the coordinate differ by up to
/// 0.03 of the time to any pose; at 1 rad less is better.
inline constexpr double moved_far_of_distance = 1.1, moved_far_of_size = 0.125;

/// A last simplex whose closest point lies outside it by more than this share of its sides is far off: time
/// over searching from it, 1 rad per step, 8 / 38 vertices, f64: 0.92 / 0.81, with 1 instead 0.99 / 0.87; at
/// 0.1 rad either 1.02 / 1.03 (Xeon with AVX-512, other load).
inline constexpr double far_off_weight = 0.3;

/// Returns true if a last simplex at this squared distance, with coordinates up to `size`, is far off: the
/// bodies have moved far since the last query ended at distance `before`.
template <class Scalar>
[[nodiscard]] bool is_farther(Scalar squared, Scalar before, Scalar size) {
    const Scalar farthest =
        static_cast<Scalar>(moved_far_of_distance) * before + static_cast<Scalar>(moved_far_of_size) * size;
    return squared > farthest * farthest;
}

/// The bodies and the sub-distance of a run, and its start.
template <SupportTable TableA, SupportTable TableB>
class GjkStart {
  public:
    using Scalar = ComputeOf<TableA>;
    using Pair = SimplexPair<TableA, TableB>;

  protected:
    GjkStart(const TableA& a, const TableB& b, const Transform<Scalar>& a_from_b, SubDistanceSolver solver)
        : a_(a), b_(b), a_from_b_(a_from_b), sub_(solver) {}

    void start(const Pair& pair) {
        is_cold_ = !pair.starts_warm(a_, b_);
        if (!is_cold_) {
            sub_.add_last(pair, a_, b_, a_from_b_);
            sub_.solve_first();
            is_cold_ = is_farther(squared_norm(sub_.closest().point), static_cast<Scalar>(pair.distance()),
                                  sub_.simplex().size);
            if (!is_cold_) return;
            sub_.clear();
        }
        start_between_origins();
    }

    /// Starts cold if that begins nearer than this squared distance, and returns true; else goes on as it is.
    /// Called when the first support points show that the last query's simplex is useless after this much
    /// motion.
    [[nodiscard]] [[gnu::noinline]] bool start_nearer(Scalar squared) {
        is_cold_ = true;
        const SubDistance<TableA, TableB> warm = sub_;
        sub_.clear();
        start_between_origins();
        if (squared_norm(sub_.closest().point) < squared) return true;
        sub_ = warm;
        is_cold_ = false;
        return false;
    }

    /// Returns the support point; a run that started cold is far from it.
    template <class Table>
    [[nodiscard]] SupportPoint<Table> support_from(const Table& table, const Vec3<Scalar>& direction,
                                                   typename Table::Vertex last) const {
        return is_cold_ ? cold_support(table, direction, last) : support(table, direction, last);
    }

    const TableA& a_;
    const TableB& b_;
    const Transform<Scalar>& a_from_b_;
    SubDistance<TableA, TableB> sub_;
    bool is_cold_ = false;

  private:
    /// Cold start: from the points of both bodies that face each other along the line of their origins.
    void start_between_origins() {
        const Vec3<Scalar>& towards_b = a_from_b_.translation;
        const auto a = support_from(a_, towards_b, a_.first_vertex());
        const auto b =
            support_from(b_, a_from_b_.direction_back(Vec3<Scalar>(-towards_b)), b_.first_vertex());
        sub_.add(a.vertex, b.vertex, a.point, a_from_b_.point(b.point));
        sub_.solve_first();
    }
};

}  // namespace edgewise
