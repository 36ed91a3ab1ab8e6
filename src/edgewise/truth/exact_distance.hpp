// SPDX-License-Identifier: MIT
//
// The distance between the convex hulls of two vertex sets, exactly. Every answer is proved before it is
// given.
//
// Doubles are whole numbers times powers of two, so x_world = R v + t, with R and t exactly as given, is a
// problem in integers: GJK (Gilbert, Johnson and Keerthi, 1988; Wolfe's minimum-norm point) on GMP integers,
// finite and without any tolerance. It departs from the textbook in where it starts (a GJK in double finds
// the simplex, the exact one confirms it or goes on) and in its support search (a scan in double with a
// proven error bound, exact only among the vertices it cannot distinguish).
#pragma once

#include <span>
#include <string_view>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/result.hpp"
#include "edgewise/truth/exact_body.hpp"

namespace edgewise::truth {

/// Closed sets: touching is distance exactly 0 without a common interior.
enum class ExactVerdict { separated, touching, overlapping };

[[nodiscard]] constexpr std::string_view to_string(ExactVerdict verdict) {
    constexpr std::string_view names[] = {"separated", "touching", "overlapping"};
    return names[static_cast<int>(verdict)];
}

struct ExactDistance {
    ExactVerdict verdict = ExactVerdict::separated;
    double distance = 0;               ///< the double nearest to the true distance
    Vec3d separation = Vec3d::Zero();  ///< a - b between closest points, each entry the nearest double
    SimplexSeed simplex;               ///< the vertices that carry the answer; a good seed for the next query
};

/// Vertex sets need not be extreme, distinct or solid. Fails on an empty set, NaN or infinity. Throws
/// std::logic_error if an answer fails its proof, which only a defect of this program can cause.
[[nodiscard]] Result<ExactDistance> exact_distance(std::span<const Vec3d> a, const Pose& pose_a,
                                                   std::span<const Vec3d> b, const Pose& pose_b,
                                                   const SimplexSeed& seed = {});

}  // namespace edgewise::truth
