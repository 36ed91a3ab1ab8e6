// SPDX-License-Identifier: MIT
//
// Checks that every vertex and every edge of a body is a real corner. On a hull with merged faces it is; a
// body with faces given as triangles, or with vertices in the middle of a side, is convex but not strictly.
// Voronoi regions of its flat edges are sheets of no thickness, which reach through the body to its far side.
// Numerically, a corner is not real if it is so small next to the body that products with coordinates hide
// it, and a face is not flat if a hull merged it from several at an angle of some rounding steps.
#pragma once

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

/// False when two neighbouring faces, or two consecutive sides of a face, turn by less than least_turn
/// (radians; tolerance.hpp, strict_turn), or when such a turn times the length of the edge, or of the shorter
/// side, is less than least_turn of the body's largest coordinate; or when a vertex lies off the plane of its
/// face by more than bent_face; or for a thin solid (thin_solid). Points and segments are strictly convex.
[[nodiscard]] bool is_strictly_convex(const Polyhedron& body, double least_turn);

/// Returns true if every vertex, except the farthest along a direction, has an edge that leads farther, up to
/// rounding: every edge turns outwards by more than rounding may cause (tolerance.hpp, climbable_turn), and
/// no face is bent. Much weaker than strictly convex, and equal for every precision.
[[nodiscard]] bool is_climbable(const Polyhedron& body);

}  // namespace edgewise
