// SPDX-License-Identifier: MIT
//
// OBJ files, in double. Assimp and Debian's tinyobjloader read single precision, take 0,5 for a number and
// name no line.
#pragma once

#include <string_view>
#include <vector>

#include "edgewise/geometry/result.hpp"
#include "edgewise/scene/mesh/mesh_parts.hpp"

namespace edgewise::scene {

/// The parts of an OBJ text. A new object (o), group (g) or material (usemtl) begins a part. A part has the
/// vertices that its faces, lines and points name, in the order of the file; the warning counts those that
/// none names. Without any, all vertices count, and belong to the part in which they stand. An error begins
/// with ":LINE: " where it is about a line, else with ": ".
[[nodiscard]] Result<std::vector<MeshPart>> obj_parts(std::string_view text);

}  // namespace edgewise::scene
