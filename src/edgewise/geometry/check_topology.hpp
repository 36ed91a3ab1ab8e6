// SPDX-License-Identifier: MIT
//
// The part of check_polyhedron that needs no coordinates: arrays, Euler's formula, twins, rings, canonical
// order.
#pragma once

#include <string>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

/// One line for each violation; empty when the arrays describe a closed surface of sphere type.
[[nodiscard]] std::vector<std::string> check_topology(const Polyhedron& body);

}  // namespace edgewise
