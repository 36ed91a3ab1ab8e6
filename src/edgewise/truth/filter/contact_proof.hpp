// SPDX-License-Identifier: MIT
//
// Bodies in contact whose Minkowski difference has the origin on its surface, or on a face of every
// tetrahedron that GJK meets (boxes face to face, bodies of one centre): two more ways to know.
#pragma once

#include "edgewise/truth/filter/posed_pair.hpp"

namespace edgewise::truth {

/// About a - b between closest points when B is moved away from A by a little: the direction along which the
/// bodies touch, if they do. Zero if that was not enough.
[[nodiscard]] Vec3d nudged_separation(PosedPair& pair);

/// Whether some point is surely inside both bodies: strictly inside a tetrahedron of vertices of either.
/// Points about halfway between the centres are tried. Then no plane separates the bodies, not even weakly.
[[nodiscard]] bool share_a_point(PosedPair& pair);

}  // namespace edgewise::truth
