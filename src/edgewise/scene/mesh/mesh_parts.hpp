// SPDX-License-Identifier: MIT
//
// What a mesh file holds, as plain points and triangles in the file's world frame. The one place that talks
// to Assimp, which knows the formats.
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
};

/// One part for each use of a mesh by a node, with the transforms of all nodes above it applied in double
/// (Assimp itself may have read the numbers in single precision). Fails on a file that cannot be read or has
/// no mesh, or whose reader takes more than the limits: those that its size tells, or these. The message does
/// not name the file.
[[nodiscard]] Result<std::vector<MeshPart>> read_mesh_parts(
    const std::string& path, const std::optional<input::GuardLimits>& limits = {});

}  // namespace edgewise::scene
