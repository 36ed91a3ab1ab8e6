// SPDX-License-Identifier: MIT
//
// Checks that the ring of a face is a convex polygon, and finds the corner to remove if it is not.
#pragma once

#include <optional>
#include <string>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

/// Largest allowed distance of a vertex of this body from a plane or a line it should be on: planarity x
/// extent, plus the rounding of a plane's offset.
[[nodiscard]] double shape_tolerance(const Polyhedron& body, double planarity);

/// Name of a face by the input's vertices: "face 0-1-3-2". Canonical face numbers mean nothing to the user.
[[nodiscard]] std::string face_name(const Polyhedron& body, Index f);

/// Returns a corner of face f that lies outside the line of one of the ring's edges by more than the
/// tolerance; a corner with an edge of no length counts too. Returns nothing if there is none.
[[nodiscard]] std::optional<Index> corner_outside(const Polyhedron& body, Index f, double tolerance);

/// The corner of face f where the ring turns most to the wrong side.
[[nodiscard]] Index most_reflex_corner(const Polyhedron& body, Index f);

}  // namespace edgewise
