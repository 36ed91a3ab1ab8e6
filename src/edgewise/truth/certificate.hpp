// SPDX-License-Identifier: MIT
//
// A certificate: an interval that provably holds the true distance of two bodies, from what an answer claims.
// A poor claim makes it wide, never wrong.
//
// Lower bound: every vertex of both bodies along a direction in world axes, R as given: the gap
// between the two along it. Upper bound: the distance of the hulls of some vertices of each body. Both are
// computed exactly, in integers, and rounded outward once at the end, so the width is that of the claim
// alone.
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

/// `on_a`, `on_b`: vertices of the features, or of the simplex, where an answer says that its closest points
/// are. Indices outside the body are skipped; if none is left, vertex 0 is used. The nearest two points of
/// their hulls, found exactly, give the upper bound; a common point proves distance 0. `direction` points
/// along the answer, either way; zero or NaN means none. The direction between the two points is tried as
/// well. Fails on an empty set, NaN or infinity in the bodies.
[[nodiscard]] Result<Certificate> certify(std::span<const Vec3d> a, const Pose& pose_a,
                                          std::span<const Vec3d> b, const Pose& pose_b,
                                          std::span<const std::uint32_t> on_a,
                                          std::span<const std::uint32_t> on_b,
                                          const Vec3d& direction = Vec3d::Zero());

/// The certificate of a stored pair, widened to hold for the given one: no vertex of A is moved by more than
/// error_a, none of B by more than error_b.
[[nodiscard]] Certificate widen(const Certificate& stored, double error_a, double error_b);

/// How far storing moves a vertex at most in the world, rounded up; vertex i is stored as vertex i. Infinity
/// if a number is not finite.
[[nodiscard]] double representation_error(std::span<const Vec3d> given, std::span<const Vec3d> stored,
                                          const Mat3d& rotation);

}  // namespace edgewise::truth
