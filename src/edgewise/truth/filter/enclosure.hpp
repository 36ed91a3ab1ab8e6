// SPDX-License-Identifier: MIT
//
// Tests if the origin is strictly inside a tetrahedron with corners known to within an error, by the signs of
// the four volumes that the origin has with its faces.
#pragma once

#include <array>

#include "edgewise/truth/filter/posed_pair.hpp"

namespace edgewise::truth {

/// Returns true only if every choice of corners within `error` of the given ones encloses the origin.
[[nodiscard]] bool surely_encloses_origin(const std::array<Vec3d, 4>& corners, double error);

/// Returns true if the origin is surely inside A - B, after a search ended with a simplex of up to three
/// points that holds it, or nearly. It may be on a face of every tetrahedron that the search meets, as in
/// symmetric bodies of one centre. Looks for points of A - B on all sides of the simplex.
[[nodiscard]] bool encloses_with_more(PosedPair& pair, const MinimumSimplex<Vec3d>& simplex);

/// About a - b between closest points when B is moved away from A by a little: the direction along which the
/// bodies touch, if they do. Zero if that was not enough.
[[nodiscard]] Vec3d nudged_separation(PosedPair& pair);

/// Returns true if some point is surely inside both: strictly inside a tetrahedron of vertices of each.
/// Points about halfway between the centres are tried. Then no plane separates the bodies, not even weakly.
[[nodiscard]] bool share_a_point(PosedPair& pair);

}  // namespace edgewise::truth
