// SPDX-License-Identifier: MIT
//
// The comparison of an answer with the exact one, with every error as a number, and the
// allowed errors by kind of pair.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "edgewise/scene/answer_claim.hpp"
#include "random_pairs.hpp"
#include "stored_bodies.hpp"

namespace edgewise {

/// A pair and its exact answer.
struct CheckedPair {
    RandomPair pair;
    truth::ExactDistance exact;
    truth::AccuracyBand band;
    double size = 0;  ///< of the larger body
    Transform<double> a_from_b;

    [[nodiscard]] bool separated() const { return exact.verdict == truth::ExactVerdict::separated; }

    /// Returns true if the gap, or the depth of the overlap, exceeds a thousandth of the size.
    [[nodiscard]] bool clear_of_contact() const {
        return separated() ? exact.distance > 1e-3 * size : std::abs(pair.gap) > 1e-3 * size;
    }
};

[[nodiscard]] inline CheckedPair check_pair(const Polyhedron& a, const Polyhedron& b, const RandomPair& pair,
                                            double eps) {
    const auto exact = truth::exact_distance(a.vertices, pair.pose_a, b.vertices, pair.pose_b);
    EXPECT_TRUE(exact) << exact.error;
    CheckedPair checked;
    checked.pair = pair;
    if (exact) checked.exact = *exact;
    checked.band = truth::accuracy_band(a.vertices, pair.pose_a, b.vertices, pair.pose_b, eps);
    checked.size = std::max(extent(a.vertices), extent(b.vertices));
    checked.a_from_b = relative_pose(pair.pose_a, pair.pose_b);
    return checked;
}

/// How far a point is outside a body; negative inside.
[[nodiscard]] inline double outside(const Polyhedron& body, const Vec3d& point) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Plane<double>& plane : body.face_planes) highest = std::max(highest, plane.distance(point));
    return highest;
}

/// Errors in units of the pair's scale; infinite instead of NaN.
struct Judged {
    bool verdict_wrong = false;
    double distance_error = 0;  ///< of the distance
    double witness_error = 0;   ///< | |p_a - p_b| - d |
    double outside = 0;         ///< of the worse witness point
};

[[nodiscard]] inline double finite_or_worst(double x) {
    return std::isfinite(x) ? x : std::numeric_limits<double>::infinity();
}

[[nodiscard]] inline Judged judge_answer(const Distance& answer, const CheckedPair& checked,
                                         const Polyhedron& a, const Polyhedron& b) {
    truth::KnownPair known(checked.exact);
    const truth::CheckedAnswer found = truth::check(
        scene::claim_of(answer), {a.vertices, checked.pair.pose_a, b.vertices, checked.pair.pose_b}, known,
        checked.band, {});
    Judged result;
    result.verdict_wrong = found.verdict_wrong;
    result.distance_error = finite_or_worst(found.band.over_scale(found.error));
    if (answer.status != Status::separated) return result;
    result.witness_error = finite_or_worst(found.band.over_scale(found.witness_error));
    const double scale = checked.band.scale;
    const Vec3d in_b = checked.a_from_b.inverse().point(answer.point_b);
    result.outside = std::max(0.0, std::max(outside(a, answer.point_a), outside(b, in_b)) / scale);
    result.outside = finite_or_worst(result.outside);
    return result;
}

/// Classes of pairs by the accuracy of their answers.
enum class Class {
    plain,     ///< full accuracy
    parallel,  ///< the right distance to within a tilt that rounding hides
};
inline constexpr std::size_t classes = 2;

template <class Table>
inline constexpr bool computes_in_single = compute_eps<Table> > Tolerance<double>::eps;

template <class Table>
inline constexpr double verified_error = truth::allowed_errors(compute_eps<Table>).distance;

/// Gap, in sizes, up to which the error on parallel features exceeds the verified error. If two edges (or an
/// edge and a face) are almost parallel, the direction of the shortest distance is only known to eps x size /
/// gap, times 64 for V-Clip's dead bands. Either algorithm may then stop at the wrong end of an edge, with an
/// error of this size.
template <class Table>
inline constexpr double parallel_reach = 64 * compute_eps<Table> / verified_error<Table>;

template <class Table>
Class classify(const CheckedPair& checked) {
    const bool close = !checked.separated() || checked.exact.distance < parallel_reach<Table> * checked.size;
    return close && checked.pair.relation != Relation::generic ? Class::parallel : Class::plain;
}

template <class Table>
constexpr double error_allowed(Class answer) {
    if (answer == Class::parallel) return computes_in_single<Table> ? 1e-3 : 2e-6;
    return verified_error<Table>;
}

}  // namespace edgewise
