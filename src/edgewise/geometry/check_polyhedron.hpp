// SPDX-License-Identifier: MIT
//
// Lists everything that is wrong with a Polyhedron: Euler's formula, twins, ring winding, convexity,
// planarity. Shape is judged to planarity x extent plus the rounding of plane offsets (tolerance.hpp).
#pragma once

#include <string>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {

/// Checks the part that needs no coordinates: arrays, Euler's formula, twins, rings, canonical order. Returns
/// an empty list when the arrays describe a closed surface of sphere type.
[[nodiscard]] std::vector<std::string> check_topology(const Polyhedron& body);

/// Returns one line for each violation; an empty list for a sound closed convex body.
[[nodiscard]] std::vector<std::string> check_polyhedron(const Polyhedron& body,
                                                        double planarity = face_planarity);

}  // namespace edgewise
