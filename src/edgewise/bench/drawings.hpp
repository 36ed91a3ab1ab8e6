// SPDX-License-Identifier: MIT
//
// Pictures of tables' memory, as SVG. A layout draws itself: one body's table to scale, a strip for each
// cache line of 64 bytes, every byte coloured by what it is for, elements set off from each other. And heat:
// the lines of a scene's tables as a grid, coloured by how often they were accessed.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "edgewise/bench/registry.hpp"

namespace edgewise::bench {

/// Drawing of the table of this body, with all parts that the layout has, placed in an arena. Lines beyond
/// 2048 are left out, and the picture says so. Throws std::invalid_argument when the layout cannot store the
/// body.
[[nodiscard]] std::string draw_layout(const TableType& type, const std::string& shape,
                                      const Polyhedron& body);

/// Drawing of the accesses of each line, from the tables' start on, of 8192 lines at most. White was never
/// accessed; light to dark is logarithmic.
[[nodiscard]] std::string draw_heat(const std::string& title, std::span<const std::uint32_t> accesses);

}  // namespace edgewise::bench
