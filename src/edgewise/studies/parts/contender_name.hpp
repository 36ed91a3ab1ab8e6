// SPDX-License-Identifier: MIT
//
// What an algorithm on a table type is called among others.
#pragma once

#include <string>

namespace edgewise::studies {

/// "V-Clip on lean_f32".
[[nodiscard]] std::string contender_name(const std::string& algorithm, const std::string& table);

}  // namespace edgewise::studies
