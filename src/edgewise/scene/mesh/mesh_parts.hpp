// SPDX-License-Identifier: MIT
//
// What a mesh file holds, as plain points and triangles in the file's world frame.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/result.hpp"
#include "edgewise/input/guarded.hpp"

namespace edgewise::scene {

struct MeshPart {
    std::string name;
    std::vector<Vec3d> points;
    std::vector<std::array<Index, 3>> triangles;  ///< polygons as fans; none for points and lines
    bool in_single = false;                       ///< the format or its reader keeps single precision
};

/// OBJ and STL files by the readers here, all others by Assimp in a child process: under the limits that the
/// file's size allows, or under these. `as_stored`: a COLLADA file's up axis and unit are left out. The error
/// and the warning are one line each, and begin with the path; errors about a line with "path:LINE: ".
[[nodiscard]] Result<std::vector<MeshPart>> read_mesh_parts(
    const std::string& path, bool as_stored = false, const std::optional<input::GuardLimits>& limits = {});

}  // namespace edgewise::scene
