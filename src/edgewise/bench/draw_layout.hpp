// SPDX-License-Identifier: MIT
//
// A layout draws itself: one body's table as a picture to scale, a strip for each cache line of 64 bytes,
// every byte coloured by what it is for, elements set off from each other.
#pragma once

#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"

namespace edgewise::bench {

/// An SVG of the map. Lines beyond `most_lines` are left out, and the picture says so.
[[nodiscard]] std::string draw_map(const std::string& title, const std::vector<MappedPiece>& map,
                                   std::size_t most_lines = 2048);

/// Of the table of this body, with all parts that the layout has, placed in an arena. Throws
/// std::invalid_argument when the layout cannot store the body.
[[nodiscard]] std::string draw_layout(const TableType& type, const std::string& shape,
                                      const Polyhedron& body);

}  // namespace edgewise::bench
