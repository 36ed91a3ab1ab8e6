// SPDX-License-Identifier: MIT
//
// Pictures of heat: the lines of a scene's tables as a grid, coloured by how often they were accessed.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace edgewise::bench {

/// SVG of the accesses of each line, from the tables' start on; at most so many lines are drawn, which the
/// picture says. White was never accessed; from light to dark is logarithmic.
[[nodiscard]] std::string draw_heat(const std::string& title, std::span<const std::uint32_t> accesses,
                                    std::size_t most_lines = 8192);

}  // namespace edgewise::bench
