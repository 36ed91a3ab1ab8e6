// SPDX-License-Identifier: MIT
//
// Reads mesh files (OBJ, STL, PLY, OFF, glTF, COLLADA ... whatever Assimp reads) into convex bodies. Node
// transforms are applied. A concave mesh is hulled, with a warning that states the ratio of the volumes.
#pragma once

#include <string>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/result.hpp"

namespace edgewise::scene {

enum class MeshGrouping {
    one_hull,   ///< all meshes of the file become one hull
    each_mesh,  ///< one hull per mesh
};

struct MeshBody {
    std::string name;  ///< file stem, with "#k" added when a file gives several bodies
    Polyhedron body;
};

/// Fails with one line that names the file and what is wrong with it: unreadable, empty, no mesh, flat, not
/// finite.
[[nodiscard]] Result<std::vector<MeshBody>> read_mesh_file(const std::string& path, MeshGrouping grouping);

}  // namespace edgewise::scene
