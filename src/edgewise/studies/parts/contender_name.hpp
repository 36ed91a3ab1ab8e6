// SPDX-License-Identifier: MIT
//
// Display name of an algorithm on a table type.
#pragma once

#include <string>

namespace edgewise::studies {

/// Returns "V-Clip on lean_f32".
[[nodiscard]] std::string contender_name(const std::string& algorithm, const std::string& table);

}  // namespace edgewise::studies
