// SPDX-License-Identifier: MIT
//
// A certificate: an interval that provably holds the true distance of two bodies, from what an answer claims.
// A poor claim makes it wide, never wrong.
//
// Lower bound: every vertex of both bodies along a direction in world axes, R as given: the gap
// between the two along it. Upper bound: the distance between two points that lie in the bodies, as means of
// vertices with non-negative weights. Both are computed exactly, in integers, and rounded outward once at the
// end, so the width is that of the claim alone.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/result.hpp"

namespace edgewise::truth {

struct Certificate {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();

    [[nodiscard]] double width() const { return upper - lower; }
};

/// The place on a body where an answer says that its closest point is. Indices outside the body are skipped;
/// if none is left, vertex 0 is used.
struct WitnessClaim {
    std::span<const std::uint32_t> vertices;  ///< of the feature, or of the simplex
    /// One per vertex, divided exactly by their sum; a weight that is not finite and positive counts as 0.
    /// Empty: the mean is not known.
    std::span<const double> weights{};
};

/// With weights on both sides the answer's own two points give the upper bound. Else the best two points of
/// the vertices named do, found exactly, and the direction between them is tried as well: this is the best
/// that these features can prove; a common point proves distance 0. The direction points along the answer,
/// either way; zero or NaN means none. Fails on an empty set, NaN or infinity in the bodies.
[[nodiscard]] Result<Certificate> certify(std::span<const Vec3d> a, const Pose& pose_a,
                                          std::span<const Vec3d> b, const Pose& pose_b,
                                          const WitnessClaim& on_a, const WitnessClaim& on_b,
                                          const Vec3d& direction = Vec3d::Zero());

/// The certificate of a stored pair, widened to hold for the given one: no vertex of A is moved by more than
/// error_a, none of B by more than error_b.
[[nodiscard]] Certificate widen(const Certificate& stored, double error_a, double error_b);

/// How far storing moves a vertex at most in the world, rounded up; vertex i is stored as vertex i. Infinity
/// if a number is not finite.
[[nodiscard]] double representation_error(std::span<const Vec3d> given, std::span<const Vec3d> stored,
                                          const Mat3d& rotation);

}  // namespace edgewise::truth
