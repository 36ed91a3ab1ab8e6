// SPDX-License-Identifier: MIT
//
// The same body with its vertices renumbered. Which vertices are neighbours in memory decides how many cache
// lines a walk over the surface touches; edges and faces follow the vertices, in the canonical order.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/result.hpp"

namespace edgewise {

enum class VertexOrder : std::uint8_t {
    given,
    bfs,      ///< breadth first from the first vertex, around each in ring order
    spatial,  ///< along a Hilbert curve through the body's box, 2^10 cells a side
    rcm,      ///< reverse Cuthill-McKee: neighbours' numbers differ little (bandwidth_order.hpp)
};

[[nodiscard]] std::string_view to_string(VertexOrder order);
/// Returns the order with this name; nothing for an unknown name.
[[nodiscard]] std::optional<VertexOrder> vertex_order_from(std::string_view name);

/// The body with its vertices in this order; `input_index` still maps to the input. Bodies without a volume
/// stay unchanged: a polygon's vertices lie in the order of its ring.
[[nodiscard]] Result<Polyhedron> reordered(const Polyhedron& body, VertexOrder order);

}  // namespace edgewise
