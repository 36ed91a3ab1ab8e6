// SPDX-License-Identifier: MIT
//
// Whether every vertex and every edge of a body is a real corner. On a hull with merged faces it is; a body
// whose faces were given as triangles, or with vertices in the middle of a side, is convex but not strictly.
// Voronoi regions of its flat edges are sheets of no thickness, which reach through the body to its far side.
// Nor is a corner real for arithmetic if it is so small beside the body that products with its coordinates
// hide it, or a face flat that a hull has merged from several at an angle of some rounding steps.
#pragma once

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

/// False when two neighbouring faces, or two consecutive sides of a face, turn by less than least_turn
/// (radians; tolerance.hpp, strict_turn), or when such a turn times the length of the edge, or of the shorter
/// side, is less than least_turn of the body's largest coordinate; or when a vertex lies off the plane of its
/// face by more than bent_face; or of a thin solid (thin_solid). Points and segments are strictly convex.
[[nodiscard]] bool is_strictly_convex(const Polyhedron& body, double least_turn);

/// Whether from every vertex but the farthest along a direction some edge leads farther, but for rounding:
/// every edge turns outwards, by more than rounding may have done (tolerance.hpp, climbable_turn), and no
/// face is bent. Much less than strictly convex, and the same for every precision.
[[nodiscard]] bool is_climbable(const Polyhedron& body);

}  // namespace edgewise
