// SPDX-License-Identifier: MIT
//
// V-Clip: the closest features of two disjoint convex polyhedra, found by stepping between neighbours.
//
// Mirtich, "V-Clip: Fast and Robust Polyhedral Collision Detection", MERL TR-97-05 (1997), ACM TOG 17(3)
// (1998). If x and y are closest points of features X and Y, and each lies in the Voronoi region of the
// other's feature, they are closest points of the bodies. Every state tests its pair and either ends or moves
// one feature to a neighbour; a move up in dimension shortens the distance, a move down keeps it. So it ends,
// in exact arithmetic.
//
// In floating point it may cycle. Where the report has an iteration limit, we detect the cycle itself
// (cycle_guard) and let a complete algorithm answer (fallback); both are counted. A cold query starts at
// the vertices that face each other (nearer_start). Where planes are derived, the first pairs of a query
// are tried by their corners before their state is (still_closest). The states' files name the other
// departures.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "edgewise/algorithms/answerable.hpp"
#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/observer.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/vclip/closest_points.hpp"
#include "edgewise/algorithms/vclip/cycle_guard.hpp"
#include "edgewise/algorithms/vclip/edge_edge.hpp"
#include "edgewise/algorithms/vclip/edge_face.hpp"
#include "edgewise/algorithms/vclip/fallback.hpp"
#include "edgewise/algorithms/vclip/feature_pair.hpp"
#include "edgewise/algorithms/vclip/nearer_start.hpp"
#include "edgewise/algorithms/vclip/still_closest.hpp"
#include "edgewise/algorithms/vclip/trust.hpp"
#include "edgewise/algorithms/vclip/vertex_edge.hpp"
#include "edgewise/algorithms/vclip/vertex_face.hpp"
#include "edgewise/algorithms/vclip/vertex_vertex.hpp"

namespace edgewise {

namespace vclip {

template <auto state, class Mine, class Theirs>
[[nodiscard]] EDGEWISE_QUERY_LOOP Step run_apart(Body<Mine>& mine, Body<Theirs>& theirs) {
    return state(mine, theirs);
}

/// Runs a state, with derived planes as a function of its own except in traces, which are not timed: inlined,
/// a query is 100 KB, three times the first cache level. Time of lean_f64 0.93 to 1.0, to compile 0.83.
template <auto state, class Mine, class Theirs>
[[nodiscard]] Step run_state(Body<Mine>& mine, Body<Theirs>& theirs) {
    if constexpr (EndsAtFeatures<Mine> && !is_traced<Mine>) return run_apart<state>(mine, theirs);
    return state(mine, theirs);
}

/// Runs one state; the kinds of the pair's two features select it.
template <class TableA, class TableB>
[[nodiscard]] Step step(Body<TableA>& a, Body<TableB>& b) {
    using enum FeatureKind;
    switch (pair_of(a.feature.kind(), b.feature.kind())) {
        case pair_of(vertex, vertex):
            return run_state<&vertex_vertex<TableA, TableB>>(a, b);
        case pair_of(vertex, edge):
            return run_state<&vertex_edge<TableA, TableB>>(a, b);
        case pair_of(edge, vertex):
            return run_state<&vertex_edge<TableB, TableA>>(b, a);
        case pair_of(vertex, face):
            return run_state<&vertex_face<TableA, TableB>>(a, b);
        case pair_of(face, vertex):
            return run_state<&vertex_face<TableB, TableA>>(b, a);
        case pair_of(edge, edge):
            return run_state<&edge_edge<TableA, TableB>>(a, b);
        case pair_of(edge, face):
            return run_state<&edge_face<TableA, TableB>>(a, b);
        case pair_of(face, edge):
            return run_state<&edge_face<TableB, TableA>>(b, a);
    }
    assert(false && "two faces are no state");
    return Step::separated;
}

template <class Scalar>
[[nodiscard]] Distance separated_by(const ClosestPoints<Scalar>& points) {
    Distance result = between(points.on_a, points.on_b);
    if (max_abs(points.normal) > 0) result.normal = points.normal.template cast<double>();
    return result;
}

template <class TableA, class TableB>
[[nodiscard]] Distance answer(const Body<TableA>& a, const Body<TableB>& b, Step last) {
    if (last == Step::separated) return separated_by(closest_points(a, b));
    return {.status = last == Step::overlapping ? Status::overlapping : Status::touching};
}

/// Answer of raw V-Clip: after a cycle from the present features; none where these are an edge and a face, or
/// where coordinates overflow.
template <class TableA, class TableB>
[[nodiscard]] Distance raw_answer(const Body<TableA>& a, const Body<TableB>& b, Step last, bool cycle) {
    if (cycle && !may_be_closest(a.feature.kind(), b.feature.kind())) return {.status = Status::failed};
    Distance result = answer(a, b, cycle ? Step::separated : last);
    if (!std::isfinite(result.distance)) result = {.status = Status::failed};
    return result;
}

/// How a run ended.
enum class End : std::uint8_t {
    proven,   ///< by the corners next to both features
    reached,  ///< by its last state
    cycled,
};

/// Answers by corners of both features; false if that is not proven.
template <class TableA, class TableB>
[[nodiscard]] bool try_corners(const Body<TableA>& a, const Body<TableB>& b, Distance& result) {
    if constexpr (is_traced<TableA>)
        return answer_by_corners(a, b, result);
    else
        return answer_by_corners_inlined(a, b, result);
}

/// Keeps the answer of a run that ended; where it is not trusted, it becomes that of its features' corners or
/// the fallback's.
template <class TableA, class TableB, class Observer>
void believe(Distance& result, Body<TableA>& a, Body<TableB>& b, Observer& observer, End end) {
    // Coordinates with products that overflow give no distance: GJK has the range, and starts cold.
    const bool is_number = std::isfinite(result.distance);
    const bool is_cycle = end == End::cycled;
    const Trust verdict = is_cycle || !is_number ? Trust::doubted : trust(result, a, b, end == End::proven);
    if (verdict == Trust::sound) return;
    const bool are_closest = try_corners(a, b, result);
    if (!are_closest) {
        observer.ask_gjk();
        result = answer_by_gjk(a, b);
    }
    result.fallbacks = !are_closest && verdict == Trust::doubted;
    result.refinements = verdict == Trust::close || (are_closest && is_cycle);
}

/// Number of pairs of a query that are tried by their corners before their states. Time of lean_f64 over
/// aos_f64, a Zen 3 with other load, in a loop of queries alone (a sweep's passes show some hundredths more),
/// 0.01 rad per step, at 8, 38, 386 vertices: with one 1.16, 1.13, 1.30, two 1.09, 1.03, 1.18, three 1.09,
/// 1.02, 1.07, nine no less. A pair far off is not proven: its state moves it on.
inline constexpr int most_proofs = 3;

/// Answers with the closest points of the pair that a query has reached after `steps` steps, where the proof
/// is tried and holds.
template <class TableA, class TableB>
[[nodiscard]] bool proven_at(bool hardened, int steps, const Body<TableA>& a, const Body<TableB>& b,
                             Distance& result) {
    if constexpr (EndsAtFeatures<TableA> && EndsAtFeatures<TableB>) {
        if (!hardened || steps > most_proofs) return false;
        const auto closest = still_closest(a, b);
        if (closest) result = separated_by(*closest);
        return closest.has_value();
    }
    return false;
}

/// Returns true if the pair after `steps` steps overlaps: boxes by a point of both, others by a pierced face.
template <class TableA, class TableB>
[[nodiscard]] bool overlaps_at(const Outlook& known, bool hardened, int steps, const Body<TableA>& a,
                               const Body<TableB>& b) {
    if constexpr (are_boxes<TableA, TableB>) return known.overlaps;
    if constexpr (ChecksPiercing<TableA> && ChecksPiercing<TableB>)
        return hardened && steps <= most_proofs && still_pierced(a, b);
    return false;
}

/// What the next query tries first after this answer, of bodies with motion that asks for `known`.
[[nodiscard]] inline FirstTry next_try(const Distance& result, FirstTry known) {
    const bool is_close = result.refinements > 0 && result.status == Status::separated;
    return is_close && known != FirstTry::nearer_start ? FirstTry::corners : known;
}

/// Walks to the closest features. `hardened`: as in QueryOptions; `first`: as in answer_from; `result`: an
/// empty one, which the answer is written to.
template <class TableA, class TableB, class Observer>
void walk(Body<TableA>& a, Body<TableB>& b, Observer& observer, bool hardened, FirstTry& first,
          Distance& result) {
    Outlook known = hardened ? start_nearer_if_far(a, b, first) : Outlook{};
    CycleGuard guard(a.feature, b.feature);
    End end = End::reached;
    int steps = 1, escapes = 0;
    for (;; ++steps) {
        if (steps == known.far_off) {
            start_nearer_on_the_way(a, b, known);
            guard = CycleGuard(a.feature, b.feature);
        }
        observer.visit(a.feature.kind(), b.feature.kind());
        if (overlaps_at(known, hardened, steps, a, b)) {
            result.status = Status::overlapping;
            break;
        }
        if (proven_at(hardened, steps, a, b, result)) {
            end = End::proven;
            break;
        }
        const Step last = step(a, b);
        escapes += last == Step::escaped;
        if (last == Step::moved || last == Step::escaped) {
            if (!guard.returns_to(a.feature, b.feature)) continue;
            end = End::cycled;
        }
        result = hardened ? answer(a, b, last) : raw_answer(a, b, last, end == End::cycled);
        break;
    }
    if (hardened) believe(result, a, b, observer, end);
    first = next_try(result, next_after<TableA, TableB>(known, steps));
    result.steps = steps;
    result.cycles = end == End::cycled;
    result.escapes = escapes;
}

/// Answers by the corners of the last features, which had been close; false if they do not hold the closest
/// points any more. In singles a walk's answer of close bodies is computed again from corners, in doubles:
/// without the walk, near queries of aos_f32 / lean_f32 in a recorded heap take 0.75 / 0.77 of the time.
template <class TableA, class TableB>
[[nodiscard]] bool answer_still_close(const Body<TableA>& a, const Body<TableB>& b, Distance& result,
                                      FirstTry& first) {
    if (!try_corners(a, b, result)) return false;
    result.steps = 1;
    result.refinements = result.distance <= untrusted<TableA, TableB> * pair_size(a, b);
    first = next_try(result, FirstTry::walk);
    return true;
}

/// Answers from where the pair's last query ended. `first`: what this query tries first; then what the next
/// one does.
template <class TableA, class TableB, class Observer>
[[nodiscard]] Distance answer_from(Body<TableA>& a, Body<TableB>& b, Observer& observer, bool hardened,
                                   FirstTry& first) {
    Distance result;
    if (hardened && first == FirstTry::corners && answer_still_close(a, b, result, first))
        observer.visit(a.feature.kind(), b.feature.kind());
    else
        walk(a, b, observer, hardened, first, result);
    return result;
}

/// Runs from the pair's last features, and notes those at which the run ends.
template <class TableA, class TableB, class Run>
[[nodiscard]] Distance run_from_last(const TableA& a, const TableB& b,
                                     const Transform<ComputeOf<TableA>>& a_from_b,
                                     FeaturePair<TableA, TableB>& pair, const QueryOptions& options,
                                     const Run& run) {
    const auto b_from_a = a_from_b.inverse();
    const bool is_known = pair.belongs_to(a, b);
    const Features<TableA, TableB> start = pair.start(a, b);
    Body<TableA> body_a{a, a_from_b, start.a};
    Body<TableB> body_b{b, b_from_a, start.b};
    FirstTry first = pair.first_try();
    Distance result = run(body_a, body_b, first);
    const Features<TableA, TableB> end{body_a.feature, body_b.feature};
    const bool is_at_rest = is_known && end == start;
    if (is_at_rest && first == FirstTry::nearer_start) first = FirstTry::walk;
    if (!is_at_rest || first != pair.first_try()) pair = {a, b, end, first};
    apply_tolerance(options, result);
    return result;
}

/// One query with everything inlined, as a symbol of its own, for the reasons given at run_gjk.
template <class TableA, class TableB>
[[nodiscard]] EDGEWISE_QUERY_LOOP Distance run(const TableA& a, const TableB& b,
                                               const Transform<ComputeOf<TableA>>& a_from_b,
                                               FeaturePair<TableA, TableB>& pair,
                                               const QueryOptions& options) {
    return run_from_last(a, b, a_from_b, pair, options, [](auto& body_a, auto& body_b, FirstTry& first) {
        NoObserver nobody;
        return answer_from(body_a, body_b, nobody, true, first);
    });
}

/// Runs one query for an observer, or with the raw algorithm.
template <class TableA, class TableB, class Observer>
[[nodiscard]] [[gnu::noinline]] Distance run_observed(const TableA& a, const TableB& b,
                                                      const Transform<ComputeOf<TableA>>& a_from_b,
                                                      FeaturePair<TableA, TableB>& pair,
                                                      const QueryOptions& options, Observer& observer) {
    return run_from_last(a, b, a_from_b, pair, options, [&](auto& body_a, auto& body_b, FirstTry& first) {
        return answer_from(body_a, body_b, observer, options.hardened, first);
    });
}

/// Passes a pose to GJK where V-Clip's two frames may disagree too much, because R is not orthogonal.
template <class TableA, class TableB, class Observer>
[[nodiscard]] [[gnu::noinline]] Distance hand_on(const TableA& a, const TableB& b,
                                                 const Transform<ComputeOf<TableA>>& a_from_b,
                                                 FeaturePair<TableA, TableB>& pair,
                                                 const QueryOptions& options, Observer& observer) {
    return run_from_last(a, b, a_from_b, pair, options, [&](auto& body_a, auto& body_b, FirstTry&) {
        observer.ask_gjk();
        Distance result = answer_by_gjk(body_a, body_b);
        result.fallbacks = 1;
        return result;
    });
}

}  // namespace vclip

/// The algorithm as the sweep and users call it.
struct VClip {
    static constexpr std::string_view name = "vclip";
    static constexpr Parts parts = Parts::features;

    template <class TableA, class TableB>
    using Pair = FeaturePair<TableA, TableB>;

    /// Distance of two bodies; `a_from_b` takes B's points into A's frame. `pair` is the start of this query
    /// and receives the closest features, the start of the next. Fails for a pose that cannot be answered
    /// (answerable.hpp); passes a rotation farther from orthogonal than sloppy_rotation to GJK.
    template <FeatureTable TableA, FeatureTable TableB, class Observer = NoObserver>
    [[nodiscard]] static Distance query(const TableA& a, const TableB& b, const Transform<double>& a_from_b,
                                        FeaturePair<TableA, TableB>& pair, const QueryOptions& options = {},
                                        Observer&& observer = {}) {
        if constexpr (compute_alike<TableA, TableB>()) {
            assert(holds_features(a) && holds_features(b) &&
                   "V-Clip needs tables built with Parts::features");
            const auto& transform = in_scalar<ComputeOf<TableA>>(a_from_b);
            if (!is_within<ComputeOf<TableA>>(a_from_b, sloppy_rotation * sloppy_rotation)) [[unlikely]] {
                if (!is_answerable<ComputeOf<TableA>>(a_from_b)) return {};
                if (options.hardened) return vclip::hand_on(a, b, transform, pair, options, observer);
            }
            if constexpr (!is_looked_at<TableA, Observer>)
                if (options.hardened) [[likely]]
                    return vclip::run(a, b, transform, pair, options);
            return vclip::run_observed(a, b, transform, pair, options, observer);
        } else {
            return {};
        }
    }

  private:
    /// False only for a table that says that it was built without features.
    template <class Table>
    [[nodiscard]] static bool holds_features(const Table& table) {
        if constexpr (requires { table.facts(); }) return table.facts().parts == Parts::features;
        return true;
    }
};

}  // namespace edgewise
