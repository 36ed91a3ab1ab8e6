// SPDX-License-Identifier: MIT
//
// Bodies in contact with the origin on the surface of their Minkowski difference, or on a face of every
// tetrahedron that GJK meets (boxes face to face, bodies of one centre): two more proofs of contact.
#pragma once

#include "edgewise/truth/filter/posed_pair.hpp"

namespace edgewise::truth {

/// About a - b between closest points when B is moved away from A by a little: the direction along which the
/// bodies touch, if they do. Zero if that was not enough.
[[nodiscard]] Vec3d nudged_separation(PosedPair& pair);

/// Returns true if some point is surely inside both: strictly inside a tetrahedron of vertices of each.
/// Points about halfway between the centres are tried. Then no plane separates the bodies, not even weakly.
[[nodiscard]] bool share_a_point(PosedPair& pair);

}  // namespace edgewise::truth
