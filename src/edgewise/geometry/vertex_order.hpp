// SPDX-License-Identifier: MIT
//
// The same body with its vertices renumbered. Which vertices are neighbours in memory decides how many cache
// lines a walk over the surface touches; edges and faces follow the vertices, in the canonical order.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/result.hpp"

namespace edgewise {

enum class VertexOrder : std::uint8_t {
    given,
    bfs,      ///< breadth first from the first vertex, around each in ring order
    spatial,  ///< along a Hilbert curve through the body's box, 2^10 cells a side
    rcm,      ///< reverse Cuthill-McKee: neighbours' numbers differ little
};

[[nodiscard]] std::string_view to_string(VertexOrder order);
/// Returns the order with this name; nothing for an unknown name.
[[nodiscard]] std::optional<VertexOrder> vertex_order_from(std::string_view name);

/// The body with its vertices in this order; `input_index` still maps to the input. Bodies without a volume
/// stay unchanged: a polygon's vertices lie in the order of its ring.
[[nodiscard]] Result<Polyhedron> reordered(const Polyhedron& body, VertexOrder order);

/// Reverse Cuthill-McKee order (Cuthill and McKee, "Reducing the bandwidth of sparse symmetric matrices", ACM
/// 1969), from a vertex at an end of the body (George and Liu, "An implementation of a pseudoperipheral node
/// finder", ACM TOMS 5, 1979): neighbours have near numbers. On a sphere of V vertices the largest difference
/// is about 2 sqrt(V): one signed byte holds it up to some 3 800. Returns for each new index the index in the
/// body. Ties go to the vertex of the smaller index.
[[nodiscard]] std::vector<Index> bandwidth_order(const Polyhedron& body);

/// Largest difference between the numbers of two neighbours.
[[nodiscard]] Index bandwidth(const Polyhedron& body);

}  // namespace edgewise
