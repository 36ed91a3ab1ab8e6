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

/// The part that needs no coordinates: arrays, Euler's formula, twins, rings, canonical order. Empty when the
/// arrays describe a closed surface of sphere type.
[[nodiscard]] std::vector<std::string> check_topology(const Polyhedron& body);

/// One line for each violation; empty for a sound closed convex body.
[[nodiscard]] std::vector<std::string> check_polyhedron(const Polyhedron& body,
                                                        double planarity = face_planarity);

}  // namespace edgewise
