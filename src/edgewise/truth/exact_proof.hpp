// SPDX-License-Identifier: MIT
//
// The proofs of exact answers, checked for every answer, independently of the search that found it.
//
// Distance: non-negative weights that sum to one put the nearest point into A - B, and no vertex pair lies
// below the plane through it. Together these two say that no other point is nearer (Kuhn-Tucker).
//
// Depth: a scan of every vertex finds all of A - B below a plane, so the depth is no larger. It is no smaller
// because the polytope is made of points of A - B, is convex, and has no face nearer to the origin than that
// plane. Convexity is checked locally (Mehlhorn et al., "Checking geometric programs or verification of
// geometric structures", 1996): the surface is closed, no neighbour rises above a face, one inner point lies
// below every face, and a ray from it meets one face only.
#pragma once

#include <span>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/result.hpp"
#include "edgewise/truth/depth/expanding_polytope.hpp"
#include "edgewise/truth/exact_body.hpp"

namespace edgewise::truth {

/// Throws std::logic_error if the simplex does not carry the point of A - B nearest to the origin.
void require_optimal(ExactPair& bodies, const MinimumSimplex<IntegerVec>& simplex);

/// Throws std::logic_error unless the depth is the distance of the origin from that face's plane.
void require_depth(ExactPair& bodies, const ExpandingPolytope& polytope, std::uint32_t face);

// How deep two convex bodies are in each other, exactly: the least translation that separates them, which is
// the least distance of the origin from a facet's plane of the Minkowski difference A - B. Every answer is
// proved before it is given (exact_proof.hpp).
//
// EPA on GMP integers: a polytope of points of A - B grows at the face that is nearest to the origin until
// that face's plane bounds all of A - B. It needs no tolerance and not the whole hull of A - B, so there is
// no limit of size but time. A pair of n-vertex spheres takes, shallow to concentric, 0.1 ms for n = 8, 0.2
// to 1 ms for 38, 0.5 to 20 ms for 386 and 2 to 120 ms for 1520.

struct ExactDepth {
    double depth = 0;  ///< the double nearest to the true depth; 0 if the bodies only touch
    /// Unit, from A towards B, each entry the nearest double: B moved by depth * normal only touches A. One
    /// of several if they are equally near. If A - B is flat (no interior, depth 0), normal to it.
    Vec3d normal = Vec3d::Zero();
};

/// Depth of bodies in contact; fails on separated bodies, an empty set, NaN or infinity. The seed may be
/// the simplex of an exact_distance of the same pair. Throws std::logic_error if an answer fails its proof,
/// which only a defect of this program can cause.
[[nodiscard]] Result<ExactDepth> exact_depth(std::span<const Vec3d> a, const Pose& pose_a,
                                             std::span<const Vec3d> b, const Pose& pose_b,
                                             const SimplexSeed& seed = {});

}  // namespace edgewise::truth
