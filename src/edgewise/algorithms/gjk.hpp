// SPDX-License-Identifier: MIT
//
// Enhanced GJK: the distance between two convex bodies as the distance of their Minkowski difference A - B
// from the origin, approached by simplices of at most four support points.
//
// Gilbert, Johnson, Keerthi 1988; Cameron 1997 for hill-climbing support and for keeping the whole simplex as
// the start of the next query. Departures: everything runs in A's frame with a relative pose; termination is
// relative (the duality gap against the rounding noise of the support products) where Cameron's is an
// absolute 1e-8 on the squared distance; a repeated support point ends the run, as does a step that gains
// nothing (Nagle's problem), even in wider arithmetic (sub_distance.hpp). Small bodies: a run that starts
// from the last answer first tries to prove it (kept_simplex.hpp); one that starts anew searches in single
// precision (search/single_search.hpp) and tries to prove what it finds. With a cutoff either first looks for
// the answer along one direction; boxes have a verdict of their own (box_verdict.hpp). gjk_start.hpp says
// where other runs start.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "edgewise/algorithms/answerable.hpp"
#include "edgewise/algorithms/box_verdict.hpp"
#include "edgewise/algorithms/distance.hpp"
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

/// Distance, witness points and normal from a run's last simplex: on_a(i), on_b(i), in A's frame, of `count`
/// points. Witness points are weighted sums of them.
/// Weights on a thin triangle are less accurate than its foot: the difference of the witnesses of separated
/// bodies from it is shared out, so that they are separated by the reported distance.
template <class Points, class Scalar>
[[nodiscard]] Distance gjk_answer(const Points& simplex, const ClosestOfSimplex<Scalar>& closest,
                                  Status status, int steps) {
    Vec3<Scalar> on_a = Vec3<Scalar>::Zero(), on_b = Vec3<Scalar>::Zero();
    for (int i = 0; i < simplex.count; ++i) {
        on_a += closest.weight[i] * simplex.on_a(i);
        on_b += closest.weight[i] * simplex.on_b(i);
    }
    Distance answer;
    answer.status = status;
    if (status == Status::separated) {
        const Vec3<Scalar> excess = Scalar(0.5) * (on_a - on_b - closest.point);
        on_a -= excess;
        on_b += excess;
        const Scalar distance = norm(closest.point);
        answer.distance = distance;
        answer.normal = Vec3<Scalar>(closest.point * (-1 / distance)).template cast<double>();
    }
    answer.point_a = on_a.template cast<double>();
    answer.point_b = on_b.template cast<double>();
    answer.steps = steps;
    return answer;
}

template <SupportTable TableA, SupportTable TableB>
class GjkRun : GjkStart<TableA, TableB> {
    using Base = GjkStart<TableA, TableB>;

  public:
    using typename Base::Pair, typename Base::Scalar;

    GjkRun(const TableA& a, const TableB& b, const Transform<Scalar>& a_from_b,
           const QueryOptions& options = {})
        : Base(a, b, a_from_b, options.sub_distance),
          contact_squared_(static_cast<Scalar>(options.contact_tolerance * options.contact_tolerance)),
          cutoff_(static_cast<Scalar>(std::max(options.cutoff, options.contact_tolerance))),
          gap_(static_cast<Scalar>(options.gap_tolerance)),
          options_(options) {
        assert(options.contact_tolerance >= 0 && options.gap_tolerance >= 0 && options.cutoff >= 0);
    }

    template <class Observer = NoObserver>
    [[nodiscard]] Distance run(Pair& pair, Observer&& observer = {}) {
        if (options_.sub_distance == SubDistanceSolver::cofactors && is_small(a_) && is_small(b_)) {
            Distance found;
            if (answer_from_last(pair, found, observer)) return found;
            if (!starts_near_ && answer_from_search(pair, found, observer)) return found;
        }
        return iterate(pair, observer);
    }

    /// Answers if the bodies are beyond the cutoff along the direction of the last simplex, or, of a cold
    /// pair, along the line of the origins. The pair stays as it is. A symbol of its own: whole distances
    /// took a tenth more instructions with it in their run.
    template <class Observer>
    [[nodiscard]] EDGEWISE_QUERY_LOOP bool answer_along_one_direction(const Pair& pair, Distance& answer,
                                                                      Observer& observer) const {
        if (options_.sub_distance != SubDistanceSolver::cofactors || !is_small(a_) || !is_small(b_))
            return false;
        const std::uint32_t count = pair.starts_warm(a_, b_) ? pair.count() : 0;
        if (count == 4 || !(cutoff_ < static_cast<Scalar>(pair.distance()))) return false;  // they are nearer
        KeptSimplex<TableA, TableB, double> kept(a_, b_, a_from_b_);
        for (std::uint32_t i = 0; i < count; ++i) kept.push(pair.corner(i).a, pair.corner(i).b);
        if (count == 0) kept.push(a_.first_vertex(), b_.first_vertex());
        const Vec3d direction = count > 0 ? kept.direction() : Vec3d(-cast<double>(a_from_b_.translation));
        if (!answer_if_beyond(kept, direction, answer)) return false;
        observer.iterate(static_cast<PointMask>((1 << kept.count) - 1));
        return true;
    }

    /// The run of a cold pair from where a search in singles ended.
    [[nodiscard]] Distance run_from(const SingleSearchEnd& end, Pair& pair) {
        if (Distance found; answer_from(end, pair, found)) return found;
        return iterate_apart(pair);
    }

  private:
    using Base::a_, Base::a_from_b_, Base::b_, Base::is_cold_, Base::sub_;

    /// Not inlined: it is rare that a search's end is not proven.
    [[nodiscard]] [[gnu::noinline]] Distance iterate_apart(Pair& pair) { return iterate(pair, NoObserver()); }

    template <class Observer>
    [[nodiscard]] Distance iterate(Pair& pair, Observer&& observer) {
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

    /// Answers from the last query's simplex, in doubles, if that provably holds the closest points still.
    /// Tried on small bodies: on large ones it fails too often for its climbs. The paper's algorithm
    /// (Johnson's search) does without.
    template <class Observer>
    [[nodiscard]] bool answer_from_last(Pair& pair, Distance& answer, Observer& observer) {
        if (!pair.starts_warm(a_, b_)) return false;
        starts_near_ = true;
        const std::uint32_t count = pair.count();
        if (count - 1 >= 3) return false;  // none, or four: they surround the origin
        KeptSimplex<TableA, TableB, double> kept(a_, b_, a_from_b_);
        for (std::uint32_t i = 0; i < count; ++i) kept.push(pair.corner(i).a, pair.corner(i).b);
        const bool rests = kept.rests_on_all();
        starts_near_ = kept.least_weight() >= -far_off_weight &&
                       !is_farther(kept.squared_distance(), double{pair.distance()}, kept.size());
        if (!rests || !starts_near_) return false;
        observer.iterate(kept.closest().members);
        observed_steps_ = 1;
        if (!kept.is_proven(options_)) return false;
        answer = gjk_answer(kept, kept.closest(), Status::separated, 1);
        pair.set_distance(answer.distance);
        return true;
    }

    /// Searches in singles for where to start, and answers from there.
    template <class Observer>
    [[nodiscard]] [[gnu::noinline]] EDGEWISE_IN_QUERY_LOOP bool answer_from_search(Pair& pair,
                                                                                   Distance& answer,
                                                                                   Observer& observer) {
        if constexpr (NumberedTable<TableA> && NumberedTable<TableB>) {
            observer.search();
            SingleSearch search;
            write_search(a_, b_, a_from_b_, cutoff_, search);
            return answer_from(run_single_search(search), pair, answer);
        }
        return false;
    }

    /// Answers from where a search ended, if that is proven; else the run starts there.
    [[nodiscard]] bool answer_from(const SingleSearchEnd& end, Pair& pair, Distance& answer) {
        steps_ = observed_steps_ = end.steps;
        pair.hold(a_, b_, end, std::numeric_limits<double>::infinity());
        const std::uint32_t count = pair.count();
        if (count - 1 >= 3) return false;  // four, or none: their handles are too large to keep
        KeptSimplex<TableA, TableB, double> kept(a_, b_, a_from_b_);
        for (std::uint32_t i = 0; i < count; ++i) kept.push(pair.corner(i).a, pair.corner(i).b);
        if (has_cutoff() && answer_if_beyond(kept, kept.direction(), answer)) return true;
        if (!answer_if_proven(kept, answer)) return false;
        pair.set_distance(answer.distance);
        return true;
    }

    [[nodiscard]] bool has_cutoff() const { return cutoff_ < std::numeric_limits<Scalar>::infinity(); }

    template <class Kept>
    [[nodiscard]] bool answer_if_beyond(const Kept& kept, const Vec3d& direction, Distance& answer) const {
        if (!kept.is_beyond(double{cutoff_}, direction)) return false;
        answer = kept.answer_beyond(direction);
        answer.steps = std::max(steps_, 1);
        return true;
    }

    template <class Kept>
    [[nodiscard]] bool answer_if_proven(Kept& kept, Distance& answer) const {
        if (!kept.rests_on_all() || !kept.is_proven(options_)) return false;
        answer = gjk_answer(kept, kept.closest(), Status::separated, steps_);
        return true;
    }

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
        return is_decided_ && reaches_closest(sub_.simplex(), sub_.closest(), sub_.simplex().size);
    }

    /// Answers an end that is not proven from the simplex, computed again more carefully, if that is proven.
    [[nodiscard]] [[gnu::noinline]] EDGEWISE_IN_QUERY_LOOP bool answer_again(Pair& pair,
                                                                             Distance& answer) const {
        const auto& simplex = sub_.simplex();
        return ask_kept_simplex(a_, b_, a_from_b_, [&](auto& kept) {
            for (int i = 0; i < simplex.count; ++i) kept.push(simplex.vertex_a(i), simplex.vertex_b(i));
            if (!answer_if_proven(kept, answer)) return false;
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
        const Distance answer = gjk_answer(sub_.simplex(), sub_.closest(), status, steps_);
        pair.hold(a_, b_, sub_.simplex(), answer.distance);
        return answer;
    }

    Scalar contact_squared_, cutoff_, gap_;
    QueryOptions options_;
    Scalar reach_ = 0;  ///< <v, w>: how far along v the whole difference is known to lie, times |v|
    int steps_ = 0, observed_steps_ = 0;  ///< observed: reported before the loop
    bool starts_near_ = false;            ///< true if the pair's simplex may hold the closest points still
    bool separates_ = false;              ///< true if a direction separates by more than rounding
    bool is_decided_ = false;             ///< true if the last support point leaves nothing to gain
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

/// The same run for an observer. Not inlined either: the straight-line vectoriser of g++ 12 would join the
/// pose's cast to single with that back to double, and drop both (geometry/hull.hpp).
template <SupportTable TableA, SupportTable TableB, class Observer>
[[nodiscard]] [[gnu::noinline]] Distance run_observed_gjk(const TableA& a, const TableB& b,
                                                          const Transform<ComputeOf<TableA>>& a_from_b,
                                                          SimplexPair<TableA, TableB>& pair,
                                                          const QueryOptions& options, Observer& observer) {
    return GjkRun<TableA, TableB>(a, b, a_from_b, options).run(pair, observer);
}

/// The same from where a search in singles ended.
template <SupportTable TableA, SupportTable TableB>
[[nodiscard]] EDGEWISE_QUERY_LOOP Distance run_gjk_from(const SingleSearchEnd& end, const TableA& a,
                                                        const TableB& b,
                                                        const Transform<ComputeOf<TableA>>& a_from_b,
                                                        SimplexPair<TableA, TableB>& pair,
                                                        const QueryOptions& options) {
    return GjkRun<TableA, TableB>(a, b, a_from_b, options).run_from(end, pair);
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
        if (options.cutoff < QueryOptions{}.cutoff) {
            Distance found;
            if (answer_as_boxes(a, b, a_from_b, options, found)) {
                observer.iterate(1);
                return found;
            }
            const GjkRun<TableA, TableB> run(a, b, transform, options);
            if (run.answer_along_one_direction(pair, found, observer)) return within(options, found);
        }
        if constexpr (is_looked_at<TableA, Observer>) {
            return within(options, run_observed_gjk(a, b, transform, pair, options, observer));
        } else {
            return within(options, run_gjk(a, b, transform, pair, options));
        }
    }

    /// Answers if both bodies are boxes and the verdict alone matters. The paper's algorithm does without.
    template <class TableA, class TableB>
    [[nodiscard]] static bool answer_as_boxes(const TableA& a, const TableB& b,
                                              const Transform<double>& a_from_b, const QueryOptions& options,
                                              Distance& answer) {
        if constexpr (BoxTable<TableA> && BoxTable<TableB>)
            return options.is_for_verdict() && options.sub_distance == SubDistanceSolver::cofactors &&
                   answer_boxes(a, b, a_from_b, options.contact_tolerance, answer);
        return false;
    }
};

}  // namespace edgewise
