// SPDX-License-Identifier: MIT
//
// One answer beside the exact one, with everything that can be wrong with it as a number.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "edgewise/scene/answer_claim.hpp"
#include "random_pairs.hpp"

namespace edgewise {

/// A question and its exact answer.
struct CheckedPair {
    RandomPair pair;
    truth::ExactDistance exact;
    truth::AccuracyBand band;
    double size = 0;  ///< of the larger body
    Transform<double> a_from_b;

    [[nodiscard]] bool separated() const { return exact.verdict == truth::ExactVerdict::separated; }

    /// Apart, or one well inside the other, by more than a thousandth of the size.
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

/// All in units of the pair's scale; infinite where there is no number.
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

}  // namespace edgewise
