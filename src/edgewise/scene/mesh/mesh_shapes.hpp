// SPDX-License-Identifier: MIT
//
// Mesh files as bodies of scenes, under the names of their files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/result.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::scene {

/// A single-precision mesh file holds only coordinates that every precision stores exactly, so that the
/// rounding of storage would never show. This map, stated in the report, gives the coordinates all their
/// digits back.
inline constexpr double mesh_scale = 1.0 + 1.0 / 3.0;

/// Whether a shape's name is that of a mesh file: built-in ones have no dot.
[[nodiscard]] inline bool names_mesh_file(std::string_view shape) { return shape.find('.') != shape.npos; }

/// Scaled by mesh_scale, hulls anew. The warning is that of read_mesh_file.
[[nodiscard]] Result<std::vector<NamedShape>> mesh_shapes(const std::string& file,
                                                          const MeshReading& reading = {});

}  // namespace edgewise::scene
