// SPDX-License-Identifier: MIT
//
// A square pyramid with a base of two triangles: a body with an edge that hardly turns, or does not.
#pragma once

#include <vector>

#include "edgewise/geometry/hull.hpp"

namespace edgewise::testing {

/// One long, one wide and one high. The corner of the base at the origin is pushed outward by `fold`, so that
/// the base is folded along the diagonal from there; at 0 it is flat.
inline Polyhedron folded_pyramid(double fold) {
    const std::vector<Vec3d> points = {{0, 0, -fold}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
    const std::vector<std::vector<Index>> faces = {{0, 3, 2}, {0, 2, 1}, {0, 1, 4},
                                                   {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    return polyhedron_from_faces(points, faces).or_throw();
}

}  // namespace edgewise::testing
