// SPDX-License-Identifier: MIT
//
// Bodies in contact: do they overlap, or only touch? Exactly: is the origin in the interior of A - B, or is
// there a plane through the origin with all of A - B on one side (a weakly separating plane)?
//
// For two solids this is whether they have a common interior point. A flat body that pierces a solid counts
// as overlapping: no small motion along any direction separates the two. If A - B itself is flat (two
// coplanar polygons, points, segments) it has no interior, and the answer is no.
#pragma once

#include "edgewise/truth/exact_body.hpp"

namespace edgewise::truth {

/// Needs a simplex that holds the origin.
[[nodiscard]] bool has_common_interior(ExactPair& bodies, const MinimumSimplex<IntegerVec>& simplex);

}  // namespace edgewise::truth
