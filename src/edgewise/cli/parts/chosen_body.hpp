// SPDX-License-Identifier: MIT
//
// The one body of a command that takes a built-in shape or a mesh file.
#pragma once

#include <string>

#include "edgewise/scene/mesh/mesh_file.hpp"

namespace edgewise::cli {

/// The hull of the mesh file, or the shape where no file is named. Warns of what is odd about a file; throws
/// std::invalid_argument: what, where, what to do.
[[nodiscard]] scene::MeshBody chosen_body(const std::string& shape, const std::string& mesh);

}  // namespace edgewise::cli
