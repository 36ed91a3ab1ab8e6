// SPDX-License-Identifier: MIT
//
// The paper's control: the interpenetration test of Moore and Wilhelms, "Collision Detection and Response for
// Computer Animation" (SIGGRAPH 1988). A vertex, an edge or a face centroid of one body strictly inside the
// other, tested both ways. It answers contact or no contact; the paper counts how often an algorithm
// disagrees.
//
// Departure: an edge is clipped against all planes at once (Cyrus and Beck), and a range that is left means a
// hit; testing the midpoints of its crossings says the same. All tests are strict: bodies that only touch are
// not in contact for it, nor is a body with its exact copy, because even the centroids lie on the surface.
#pragma once

#include <optional>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise::truth {

/// Returns true if the bodies interpenetrate; no value for flat bodies, which have no inside. `a_from_b`
/// takes B's points into A's frame. Tests every vertex, edge and face of one body against every face of the
/// other: a reference, not an algorithm to time.
[[nodiscard]] std::optional<bool> moore_wilhelms(const Polyhedron& a, const Polyhedron& b,
                                                 const Transform<double>& a_from_b);

}  // namespace edgewise::truth
