// SPDX-License-Identifier: MIT
//
// An order of vertices in which neighbours have near numbers: reverse Cuthill-McKee (Cuthill and McKee,
// "Reducing the bandwidth of sparse symmetric matrices", ACM 1969), from a vertex at an end of the body
// (George and Liu, "An implementation of a pseudoperipheral node finder", ACM TOMS 5, 1979). On a sphere of V
// vertices the largest difference is about 2 sqrt(V): one signed byte holds it up to some 3 800.
#pragma once

#include <vector>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

/// Returns for each new index the index in the body. Ties go to the vertex of the smaller index.
[[nodiscard]] std::vector<Index> bandwidth_order(const Polyhedron& body);

/// Largest difference between the numbers of two neighbours.
[[nodiscard]] Index bandwidth(const Polyhedron& body);

}  // namespace edgewise
