// SPDX-License-Identifier: MIT
//
// Is the origin strictly inside a tetrahedron whose corners are known to within an error? By the signs of the
// four volumes that the origin has with its faces.
#pragma once

#include <array>

#include "edgewise/truth/filter/posed_pair.hpp"

namespace edgewise::truth {

/// True only if it is for every choice of corners within `error` of these.
[[nodiscard]] bool surely_encloses_origin(const std::array<Vec3d, 4>& corners, double error);

/// Whether the origin is surely inside A - B, where a search ended with a simplex of up to three points that
/// holds it, or nearly: it may be on a face of every tetrahedron that the search meets, as in symmetric
/// bodies of one centre. Looks for points of A - B on all sides of the simplex.
[[nodiscard]] bool encloses_with_more(PosedPair& pair, const MinimumSimplex<Vec3d>& simplex);

}  // namespace edgewise::truth
