// SPDX-License-Identifier: MIT
//
// The corpus: case files of pairs on which some collision library was wrong, crashed or did not end, each
// with its source; and the same pairs seen otherwise (swapped, listed backwards, scaled).
#pragma once

#include <string>
#include <vector>

#include "edgewise/scene/case_file.hpp"

namespace edgewise {

/// All cases of all files in the corpus folder, in the order of files and lines.
[[nodiscard]] const std::vector<Case>& corpus();

[[nodiscard]] Case swapped(const Case& given);

/// Every vertex list backwards, faces renumbered to match.
[[nodiscard]] Case reversed(const Case& given);

/// The whole scene times 2^exponent.
[[nodiscard]] Case scaled_by_power(const Case& given, int exponent);

}  // namespace edgewise
