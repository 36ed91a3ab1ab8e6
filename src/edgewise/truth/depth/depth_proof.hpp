// SPDX-License-Identifier: MIT
//
// The proof of a penetration depth, checked for every answer, independently of the search that found it.
//
// Not deeper: a scan of every vertex finds all of A - B below the plane. Not shallower: the polytope is made
// of points of A - B, it is convex, and none of its faces is nearer to the origin than that plane. That it is
// convex is seen locally (Mehlhorn et al., "Checking geometric programs or verification of geometric
// structures", 1996): the surface is closed, no neighbour rises above a face, one inner point lies below
// every face, and a ray from it meets one face only.
#pragma once

#include "edgewise/truth/depth/expanding_polytope.hpp"
#include "edgewise/truth/exact_body.hpp"

namespace edgewise::truth {

/// Throws std::logic_error unless the depth is the distance of the origin from that face's plane.
void require_depth(ExactPair& bodies, const ExpandingPolytope& polytope, std::uint32_t face);

}  // namespace edgewise::truth
