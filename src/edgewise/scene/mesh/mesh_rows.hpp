// SPDX-License-Identifier: MIT
//
// Rows of PLY and OFF files against what their headers announce. Assimp takes a row of a face for a vertex
// where a count is off by one, and 0,5 for a number.
#pragma once

#include <string>
#include <string_view>

namespace edgewise::scene {

/// Empty, or ":LINE: " and what is wrong there, or ": " and what is wrong with the whole. The header is one
/// that mesh_header_error takes.
[[nodiscard]] std::string ply_rows_error(std::string_view bytes);
[[nodiscard]] std::string off_rows_error(std::string_view text);

}  // namespace edgewise::scene
