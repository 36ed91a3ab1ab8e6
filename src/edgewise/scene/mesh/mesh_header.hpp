// SPDX-License-Identifier: MIT
//
// What a mesh file's header announces, held against the file's bytes before a parser reserves memory for it
// or looks for lines that are not there: PLY (paulbourke.net/dataformats/ply) and OFF
// (paulbourke.net/dataformats/off). Binary STL is held against its count by stl_file.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace edgewise::scene {

/// Empty, or what is wrong with the file at that path, whose ending or first letters say which format it is.
[[nodiscard]] std::string mesh_header_error(const std::string& path);
/// Likewise from the path's ending, the file's first bytes and how many it has.
[[nodiscard]] std::string mesh_header_error(const std::string& ending, const std::string& head,
                                            std::uint64_t bytes);

/// Bytes of a PLY scalar; 1 of an unknown one.
[[nodiscard]] std::uint64_t ply_bytes(std::string_view type);

}  // namespace edgewise::scene
