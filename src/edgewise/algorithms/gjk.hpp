// SPDX-License-Identifier: MIT
//
// Enhanced GJK: the distance between two convex bodies as the distance of their Minkowski difference A - B
// from the origin, approached by simplices of at most four support points.
//
// Gilbert, Johnson, Keerthi 1988; Cameron 1997 for hill-climbing support and for keeping the whole simplex as
// the start of the next query. Departures: everything runs in A's frame with a relative pose; termination is
// relative (the duality gap against the rounding noise of the support products) where Cameron's is an
// absolute 1e-8 on the squared distance; a repeated support point ends the run, as does a step that gains
// nothing (Nagle's problem), even in wider arithmetic (sub_distance.hpp). On small bodies GJK first looks for
// an answer without a run (early_answer.hpp): the last one, proven again, or what a search in single
// precision finds. Boxes have a verdict of their own (box_verdict.hpp). gjk_start.hpp says where runs start.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string_view>

#include "edgewise/algorithms/answerable.hpp"
#include "edgewise/algorithms/box_verdict.hpp"
#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/early_answer.hpp"
#include "edgewise/algorithms/gjk_start.hpp"
#include "edgewise/algorithms/kept_simplex.hpp"
#include "edgewise/algorithms/observer.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/search/single_search.hpp"
#include "edgewise/algorithms/simplex_pair.hpp"
#include "edgewise/algorithms/sub_distance.hpp"
#include "edgewise/algorithms/subset.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise {

template <SupportTable TableA, SupportTable TableB>
class GjkRun : GjkStart<TableA, TableB> {
    using Base = GjkStart<TableA, TableB>;

  public:
    using typename Base::Pair, typename Base::Scalar;

    GjkRun(const TableA& a, const TableB& b, const Transform<Scalar>& a_from_b,
           const QueryOptions& options = {}, EarlySteps before = {})
        : Base(a, b, a_from_b, options.sub_distance),
          contact_squared_(static_cast<Scalar>(options.contact_tolerance * options.contact_tolerance)),
          cutoff_(options.cutoff_in<Scalar>()),
          gap_(static_cast<Scalar>(options.gap_tolerance)),
          options_(options),
          steps_(before.taken),
          observed_steps_(before.observed) {}

    template <class Observer = NoObserver>
    [[nodiscard]] Distance run(Pair& pair, Observer&& observer = {}) {
        this->start(pair);
        while (steps_ < most_gjk_iterations) {
            if (++steps_ > observed_steps_) observer.iterate(sub_.closest().members);
            if (sub_.simplex().count == 4) return finish(pair, Status::overlapping);
            const Scalar squared = squared_norm(sub_.closest().point);
            if (squared > contact_squared_ && advance(squared)) continue;
            if (is_proven()) return finish(pair, separated_or_contact());
            if (Distance again; squared > contact_squared_ && answer_again(pair, again)) return again;
            if (!sub_.solve_close_in_wide())
                return finish(pair, squared == 0 ? Status::touching : separated_or_contact());
        }
        assert(false && "GJK does not converge: a shape's vertices are not those of a convex body");
        pair = Pair(a_, b_);
        return {.steps = steps_};
    }

  private:
    using Base::a_, Base::a_from_b_, Base::b_, Base::is_cold_, Base::sub_;

    /// Adds one support point; false when nothing is left to gain.
    [[nodiscard]] bool advance(Scalar squared) {
        const auto& simplex = sub_.simplex();
        const Vec3<Scalar>& v = sub_.closest().point;
        const auto a = this->support_from(a_, Vec3<Scalar>(-v), simplex.vertex_a(simplex.count - 1));
        const auto b =
            this->support_from(b_, a_from_b_.direction_back(v), simplex.vertex_b(simplex.count - 1));
        const Vec3<Scalar> on_b = a_from_b_.point(b.point);
        const Scalar root = std::sqrt(squared), length = root * simplex.size;
        const Scalar noise = Tolerance<Scalar>::support_noise * length;
        reach_ = dot(v, Vec3<Scalar>(a.point - on_b));
        separates_ = reach_ > noise;
        if (reach_ - noise > cutoff_ * root) {
            is_decided_ = true;
            return false;
        }
        if (steps_ == 1 && !is_cold_ && reach_ < static_cast<Scalar>(far_off_simplex) * squared &&
            this->start_nearer(squared))
            return true;
        is_decided_ = squared - reach_ <= std::max(Tolerance<Scalar>::open_gap * length, gap_ * squared);
        if (is_decided_ || simplex.holds(a.vertex, b.vertex)) return false;
        return sub_.extend(a.vertex, b.vertex, a.point, on_b, squared, separates_);
    }

    /// Returns true if the run may end here: no vertex of the difference lies nearer along the closest
    /// point's direction, and the simplex reaches that point.
    [[nodiscard]] bool is_proven() const {
        if (!is_decided_) return false;
        const WitnessPoints<Scalar> witnesses(sub_.simplex(), sub_.closest());
        return witnesses.are_as_near_as(norm(sub_.closest().point), sub_.simplex().size);
    }

    /// Answers an end that is not proven from the simplex, computed again more carefully, if that is proven.
    [[nodiscard]] [[gnu::noinline]] EDGEWISE_IN_QUERY_LOOP bool answer_again(Pair& pair,
                                                                             Distance& answer) const {
        const auto& simplex = sub_.simplex();
        return ask_kept_simplex(a_, b_, a_from_b_, [&](auto& kept) {
            for (int i = 0; i < simplex.count; ++i) kept.push(simplex.vertex_a(i), simplex.vertex_b(i));
            if (!kept.rests_on_all() || !kept.is_proven(options_)) return false;
            kept.write(answer);
            answer.steps = steps_;
            pair.hold(a_, b_, simplex, answer.distance);
            return true;
        });
    }

    /// At the origin with a direction that separates nothing: contact within this precision.
    [[nodiscard]] Status separated_or_contact() const {
        const bool at_origin =
            max_abs(sub_.closest().point) <= Tolerance<Scalar>::contact_noise * sub_.simplex().size;
        return at_origin && !separates_ ? Status::touching : Status::separated;
    }

    [[nodiscard]] Distance finish(Pair& pair, Status status) const {
        const WitnessPoints<Scalar> witnesses(sub_.simplex(), sub_.closest());
        Distance answer;
        answer.status = status;
        answer.steps = steps_;
        answer.point_a = cast<double>(witnesses.on_a);
        answer.point_b = cast<double>(witnesses.on_b);
        const Vec3<Scalar>& closest = sub_.closest().point;
        if (status == Status::separated) witnesses.write_separated(closest, norm(closest), answer);
        pair.hold(a_, b_, sub_.simplex(), answer.distance);
        return answer;
    }

    Scalar contact_squared_, cutoff_, gap_;
    QueryOptions options_;
    Scalar reach_ = 0;  ///< <v, w>: how far along v the whole difference is known to lie, times |v|
    int steps_ = 0, observed_steps_ = 0;  ///< observed: reported before the loop
    bool separates_ = false;              ///< true if a direction separates by more than rounding
    bool is_decided_ = false;             ///< true if the last support point leaves nothing to gain
};

/// Iterates from the pair's simplex. Not inlined: most small bodies do not need it.
template <SupportTable TableA, SupportTable TableB>
EDGEWISE_QUERY_LOOP void iterate_gjk(const TableA& a, const TableB& b,
                                     const Transform<ComputeOf<TableA>>& a_from_b,
                                     SimplexPair<TableA, TableB>& pair, const QueryOptions& options,
                                     EarlySteps before, Distance& answer) {
    answer = GjkRun<TableA, TableB>(a, b, a_from_b, options, before).run(pair);
}

/// Answers a query from where a search in singles ended. Not inlined: most coherent queries need no search.
template <SupportTable TableA, SupportTable TableB>
EDGEWISE_QUERY_LOOP void run_gjk_from(const SingleSearchEnd& end, const TableA& a, const TableB& b,
                                      const Transform<ComputeOf<TableA>>& a_from_b,
                                      SimplexPair<TableA, TableB>& pair, const QueryOptions& options,
                                      Distance& answer) {
    EarlyAnswer<TableA, TableB> early(a, b, a_from_b, options);
    if (!early.from_end(end, pair, answer)) iterate_gjk(a, b, a_from_b, pair, options, early.steps(), answer);
}

/// One query with everything inlined: calls cost a tenth of it. A symbol of its own, which a library of table
/// types may hold and others use (`extern template`). Not flattened under sanitizers: instrumented code is
/// not inlined into other code, and g++ took minutes for one query otherwise. `answer`: an empty one.
template <SupportTable TableA, SupportTable TableB>
EDGEWISE_QUERY_LOOP void run_gjk(const TableA& a, const TableB& b,
                                 const Transform<ComputeOf<TableA>>& a_from_b,
                                 SimplexPair<TableA, TableB>& pair, const QueryOptions& options,
                                 Distance& answer) {
    NoObserver nobody;
    EarlyAnswer<TableA, TableB> early(a, b, a_from_b, options);
    if (early.from_last(pair, answer, nobody)) return;
    if constexpr (NumberedTable<TableA> && NumberedTable<TableB>) {
        if (early.may_search()) {
            run_gjk_from(early.search(), a, b, a_from_b, pair, options, answer);
            return;
        }
    }
    iterate_gjk(a, b, a_from_b, pair, options, early.steps(), answer);
}

/// The same query for an observer. Not inlined either: the straight-line vectoriser of g++ 12 would join the
/// pose's cast to single with that back to double, and drop both (geometry/hull.hpp).
template <SupportTable TableA, SupportTable TableB, class Observer>
[[gnu::noinline]] void run_observed_gjk(const TableA& a, const TableB& b,
                                        const Transform<ComputeOf<TableA>>& a_from_b,
                                        SimplexPair<TableA, TableB>& pair, const QueryOptions& options,
                                        Observer&& observer, Distance& answer) {
    EarlyAnswer<TableA, TableB> early(a, b, a_from_b, options);
    if (early.from_last(pair, answer, observer)) return;
    if constexpr (NumberedTable<TableA> && NumberedTable<TableB>) {
        if (early.may_search()) {
            observer.search();
            if (early.from_end(early.search(), pair, answer)) return;
        }
    }
    answer = GjkRun<TableA, TableB>(a, b, a_from_b, options, early.steps()).run(pair, observer);
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
        Distance result;  // not of an inner scope: its copy would wait for the query's last stores (g++ 12)
        if constexpr (compute_alike<TableA, TableB>()) {
            if (!is_answerable(a, b, a_from_b)) [[unlikely]]
                return result;
            const auto& transform = in_scalar<ComputeOf<TableA>>(a_from_b);
            PointMask members = 0;
            if (options.has_cutoff()) {
                if constexpr (BoxTable<TableA> && BoxTable<TableB>)
                    members = options.is_for_verdict() &&
                              options.sub_distance == SubDistanceSolver::cofactors &&
                              answer_boxes(a, b, a_from_b, options.contact_tolerance, result);
                const EarlyAnswer<TableA, TableB> early(a, b, transform, options);
                if (members == 0) members = early.along_one_direction(pair, result);
            }
            if (members != 0)
                observer.iterate(members);
            else if constexpr (is_looked_at<TableA, Observer>)
                run_observed_gjk(a, b, transform, pair, options, observer, result);
            else
                run_gjk(a, b, transform, pair, options, result);
            apply_tolerance(options, result);
        }
        return result;
    }
};

}  // namespace edgewise
