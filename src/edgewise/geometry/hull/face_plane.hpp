// SPDX-License-Identifier: MIT
//
// The plane of a polygon. The normal is Newell's area vector (the sum over all corners, so no corner is
// favoured and a sliver has a plane wherever its area is not zero), summed in two-fold precision. The offset
// lies halfway between the lowest and the highest vertex along the normal: the best plane with that normal.
#pragma once

#include <span>

#include "edgewise/geometry/plane.hpp"
#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

/// Plane with a unit normal on the side from which the ring runs counter-clockwise; a zero normal when the
/// ring encloses no area. `scale`: a power of two that takes the body to about unit size.
[[nodiscard]] Plane<double> face_plane(std::span<const Vec3d> vertices, std::span<const Index> ring,
                                       double scale);

}  // namespace edgewise
