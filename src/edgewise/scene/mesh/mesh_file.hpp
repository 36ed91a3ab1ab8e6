// SPDX-License-Identifier: MIT
//
// Reads mesh files (OBJ, STL, and what Assimp reads: PLY, OFF, glTF, COLLADA ...) into convex bodies. Node
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

struct MeshReading {
    MeshGrouping grouping = MeshGrouping::one_hull;
    bool as_stored = false;   ///< a COLLADA file's up axis and unit are left out
    bool takes_flat = false;  ///< polygons, segments and points are bodies too
};

struct MeshBody {
    std::string name;  ///< file stem, with "#k" added when a file gives several bodies
    Polyhedron body;
    std::vector<Vec3d> points = {};  ///< of the mesh, each once, in the order of the file
    /// Distance between neighbouring numbers of single precision at its largest coordinate, where it was read
    /// in that; 0: in double.
    double step = 0;
};

/// Fails with one line that names the file and what is wrong with it: unreadable, empty, no mesh, flat, not
/// finite. The warning names what was done to the bodies, and where single precision is too coarse for one.
[[nodiscard]] Result<std::vector<MeshBody>> read_mesh_file(const std::string& path,
                                                           const MeshReading& reading = {});

}  // namespace edgewise::scene
