// SPDX-License-Identifier: MIT
//
// Mesh parts as bytes and back, for the way from the process that reads a file to the one that uses it: both
// are this program.
#pragma once

#include <string>
#include <string_view>

#include "edgewise/scene/mesh/mesh_parts.hpp"

namespace edgewise::scene {

/// Of the parts, or of the error.
[[nodiscard]] std::string bytes_of(const Result<std::vector<MeshPart>>& parts);

/// What bytes_of took; of bytes that are cut short a failure.
[[nodiscard]] Result<std::vector<MeshPart>> parts_from(std::string_view bytes);

}  // namespace edgewise::scene
