// SPDX-License-Identifier: MIT
//
// Enhanced GJK: the distance between two convex bodies as the distance of their Minkowski difference A - B
// from the origin, approached by simplices of at most four support points.
//
// Gilbert, Johnson, Keerthi 1988; Cameron 1997 for hill-climbing support and for keeping the whole simplex as
// the start of the next query. Departures: everything runs in A's frame with a relative pose; termination is
// relative (the duality gap against the rounding noise of the support products) where Cameron's is an
// absolute 1e-8 on the squared distance; a repeated support point ends the run, as does a step that gains
// nothing (Nagle's problem), even in wider arithmetic (sub_distance.hpp). A cold query starts at the points
// that face each other along the line of the origins, not anywhere. A warm query with an old simplex that now
// lies much farther off, or proves useless, starts again from these points.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "edgewise/algorithms/answerable.hpp"
#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/gjk_answer.hpp"
#include "edgewise/algorithms/observer.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/simplex.hpp"
#include "edgewise/algorithms/simplex_pair.hpp"
#include "edgewise/algorithms/sub_distance.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise {

template <SupportTable TableA, SupportTable TableB>
class GjkRun {
  public:
    using Scalar = ComputeOf<TableA>;
    using Pair = SimplexPair<TableA, TableB>;

    GjkRun(const TableA& a, const TableB& b, const Transform<Scalar>& a_from_b,
           const QueryOptions& options = {})
        : a_(a),
          b_(b),
          a_from_b_(a_from_b),
          sub_(options.sub_distance),
          contact_squared_(static_cast<Scalar>(options.contact_tolerance * options.contact_tolerance)),
          gap_(static_cast<Scalar>(options.gap_tolerance)),
          verdict_only_(options.verdict_only) {
        assert(options.contact_tolerance >= 0 && options.gap_tolerance >= 0);
    }

    template <class Observer = NoObserver>
    [[nodiscard]] Distance run(Pair& pair, Observer&& observer = {}) {
        start(pair);
        while (steps_ < most_gjk_iterations) {
            ++steps_;
            observer.iterate(sub_.closest().members);
            if (sub_.simplex().count == 4) return finish(pair, Status::overlapping);
            const Scalar squared = squared_norm(sub_.closest().point);
            if (squared == 0) return finish(pair, Status::touching);
            if (squared <= contact_squared_ || !advance(squared)) return finish(pair, separated_or_contact());
        }
        assert(false && "GJK does not converge: a shape's vertices are not those of a convex body");
        pair = Pair(a_, b_);
        return {.steps = steps_};
    }

  private:
    void start(const Pair& pair) {
        is_cold_ = !pair.starts_warm(a_, b_);
        if (!is_cold_) {
            sub_.add_last(pair, a_, b_, a_from_b_);
            sub_.solve_first();
            is_cold_ = lies_farther(static_cast<Scalar>(pair.distance()));
            if (!is_cold_) return;
            sub_.clear();
        }
        start_between_origins();
        sub_.solve_first();
    }

    /// Returns true if the bodies have moved far since the last query ended at distance `before`.
    [[nodiscard]] bool lies_farther(Scalar before) const {
        const Scalar farthest = static_cast<Scalar>(moved_far_of_distance) * before +
                                static_cast<Scalar>(moved_far_of_size) * sub_.simplex().size;
        return squared_norm(sub_.closest().point) > farthest * farthest;
    }

    /// Cold start: from the points of both bodies that face each other along the line of their origins.
    void start_between_origins() {
        const Vec3<Scalar>& towards_b = a_from_b_.translation;
        const auto a = support_from(a_, towards_b, a_.first_vertex());
        const auto b =
            support_from(b_, a_from_b_.direction_back(Vec3<Scalar>(-towards_b)), b_.first_vertex());
        sub_.add(a.vertex, b.vertex, a.point, a_from_b_.point(b.point));
    }

    /// Called when the first support points show that the last query's simplex is useless after this much
    /// motion. Starts cold, if that begins nearer.
    [[nodiscard]] [[gnu::noinline]] bool start_nearer(Scalar squared) {
        is_cold_ = true;
        const SubDistance<TableA, TableB> warm = sub_;
        sub_.clear();
        start_between_origins();
        sub_.solve_first();
        if (squared_norm(sub_.closest().point) < squared) return true;
        sub_ = warm;
        is_cold_ = false;
        return false;
    }

    template <class Table>
    [[nodiscard]] SupportPoint<Table> support_from(const Table& table, const Vec3<Scalar>& direction,
                                                   typename Table::Vertex last) const {
        return is_cold_ ? cold_support(table, direction, last) : support(table, direction, last);
    }

    /// Adds one support point; false when nothing is left to gain.
    [[nodiscard]] bool advance(Scalar squared) {
        const auto& simplex = sub_.simplex();
        const Vec3<Scalar>& v = sub_.closest().point;
        const auto a = support_from(a_, Vec3<Scalar>(-v), simplex.vertex_a(simplex.count - 1));
        const auto b = support_from(b_, a_from_b_.direction_back(v), simplex.vertex_b(simplex.count - 1));
        const Vec3<Scalar> on_b = a_from_b_.point(b.point);
        const Scalar noise = Tolerance<Scalar>::support_noise * std::sqrt(squared) * simplex.size;
        reach_ = dot(v, Vec3<Scalar>(a.point - on_b));
        separates_ = reach_ > noise;
        if (verdict_only_ && reach_ - noise > std::sqrt(contact_squared_ * squared)) return false;
        if (steps_ == 1 && !is_cold_ && reach_ < static_cast<Scalar>(far_off_simplex) * squared &&
            start_nearer(squared))
            return true;
        if (simplex.holds(a.vertex, b.vertex) || squared - reach_ <= std::max(noise, gap_ * squared))
            return false;
        return sub_.extend(a.vertex, b.vertex, a.point, on_b, squared, separates_);
    }

    /// At the origin with a direction that separates nothing: contact within this precision.
    [[nodiscard]] Status separated_or_contact() const {
        const bool at_origin =
            max_abs(sub_.closest().point) <= Tolerance<Scalar>::contact_noise * sub_.simplex().size;
        return at_origin && !separates_ ? Status::touching : Status::separated;
    }

    [[nodiscard]] Distance finish(Pair& pair, Status status) const {
        const Distance answer = gjk_answer(sub_.simplex(), sub_.closest(), status, steps_);
        pair.hold(a_, b_, sub_.simplex(), answer.distance);
        return answer;
    }

    const TableA& a_;
    const TableB& b_;
    const Transform<Scalar>& a_from_b_;
    SubDistance<TableA, TableB> sub_;
    Scalar contact_squared_, gap_;  ///< QueryOptions
    bool verdict_only_;
    Scalar reach_ = 0;  ///< <v, w>: how far along v the whole difference is known to lie, times |v|
    int steps_ = 0;
    bool is_cold_ = false;
    bool separates_ = false;  ///< true if a direction separates by more than rounding
};

/// One run with everything inlined: calls cost a tenth of it. A symbol of its own, which a library of table
/// types may hold and others use (`extern template`). Not flattened under sanitizers: instrumented code is
/// not inlined into other code, and g++ took minutes for one query otherwise.
template <SupportTable TableA, SupportTable TableB>
[[nodiscard]] EDGEWISE_QUERY_LOOP Distance run_gjk(const TableA& a, const TableB& b,
                                                   const Transform<ComputeOf<TableA>>& a_from_b,
                                                   SimplexPair<TableA, TableB>& pair,
                                                   const QueryOptions& options) {
    return GjkRun<TableA, TableB>(a, b, a_from_b, options).run(pair);
}

/// The algorithm as the sweep and users call it.
struct Gjk {
    static constexpr std::string_view name = "gjk";
    static constexpr Parts parts = Parts::support;

    template <class TableA, class TableB>
    using Pair = SimplexPair<TableA, TableB>;

    /// Distance of two bodies; `a_from_b` takes B's points into A's frame. `pair` is the start of this query
    /// and receives the start of the next. Fails for an invalid pose (answerable.hpp).
    template <SupportTable TableA, SupportTable TableB, class Observer = NoObserver>
    [[nodiscard]] static Distance query(const TableA& a, const TableB& b, const Transform<double>& a_from_b,
                                        SimplexPair<TableA, TableB>& pair, const QueryOptions& options = {},
                                        Observer&& observer = {}) {
        if constexpr (compute_alike<TableA, TableB>())
            return answer(a, b, a_from_b, pair, options, observer);
        else
            return {};
    }

  private:
    template <class TableA, class TableB, class Observer>
    [[nodiscard]] static Distance answer(const TableA& a, const TableB& b, const Transform<double>& a_from_b,
                                         SimplexPair<TableA, TableB>& pair, const QueryOptions& options,
                                         Observer& observer) {
        if (!is_answerable(a, b, a_from_b)) [[unlikely]]
            return {};
        const auto transform = cast<ComputeOf<TableA>>(a_from_b);
        constexpr bool observed = !std::is_same_v<std::remove_cvref_t<Observer>, NoObserver>;
        if constexpr (observed || is_traced<TableA>) {
            return within(options, GjkRun<TableA, TableB>(a, b, transform, options).run(pair, observer));
        } else {
            return within(options, run_gjk(a, b, transform, pair, options));
        }
    }
};

}  // namespace edgewise
