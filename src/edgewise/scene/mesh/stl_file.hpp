// SPDX-License-Identifier: MIT
//
// STL files: text in double, whatever the case of its keywords, and binary, which stores single precision.
// Assimp refuses both without a reason where a count or a keyword is not as it expects.
#pragma once

#include <string_view>
#include <vector>

#include "edgewise/geometry/result.hpp"
#include "edgewise/scene/mesh/mesh_parts.hpp"

namespace edgewise::scene {

/// One part for each solid. An error begins with ":LINE: " where it is about a line of a text, else with ":
/// ".
[[nodiscard]] Result<std::vector<MeshPart>> stl_parts(std::string_view bytes);

}  // namespace edgewise::scene
