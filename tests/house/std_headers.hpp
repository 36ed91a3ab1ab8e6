// SPDX-License-Identifier: MIT
//
// Include what you use, for the standard library and the headers that are installed: another library may
// bring fewer headers along with those that are named.
#pragma once

#include <vector>

#include "source_tree.hpp"

namespace edgewise::house {

/// Standard names whose header is not included where they stand, and names that the check does not know.
[[nodiscard]] std::vector<Violation> missing_std_headers(const std::vector<SourceFile>& files);

}  // namespace edgewise::house
