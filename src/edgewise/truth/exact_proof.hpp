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

#include <array>

#include "edgewise/truth/depth/expanding_polytope.hpp"
#include "edgewise/truth/exact_body.hpp"

namespace edgewise::truth {

/// The weights of the nearest point, up to a common positive factor.
[[nodiscard]] std::array<mpz_class, 4> simplex_weights(const MinimumSimplex<IntegerVec>& s);

/// Throws std::logic_error if the simplex does not carry the point of A - B nearest to the origin.
void require_optimal(ExactPair& bodies, const MinimumSimplex<IntegerVec>& simplex);

/// Throws std::logic_error unless the depth is the distance of the origin from that face's plane.
void require_depth(ExactPair& bodies, const ExpandingPolytope& polytope, std::uint32_t face);

}  // namespace edgewise::truth
