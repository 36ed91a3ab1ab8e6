// SPDX-License-Identifier: MIT
//
// The break-even map as a picture: a grid for each number of tables, vertices across, coherence downwards. A
// place is tinted in the colour of the layout that wins; one where several tie has a bar of all their colours
// and no tint; one that was not measured is dashed and says so.
#pragma once

#include <string>

#include "edgewise/reports/answer/break_even_map.hpp"

namespace edgewise::reports {

/// Empty where nothing was measured.
[[nodiscard]] std::string break_even_svg(const BreakEvenMap& map);

}  // namespace edgewise::reports
