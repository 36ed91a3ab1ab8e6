// SPDX-License-Identifier: MIT
//
// Reads mesh files (OBJ, STL, and what Assimp reads: PLY, OFF, glTF, COLLADA ...) into convex bodies. Node
// transforms are applied. A concave mesh is hulled, with a warning that states the ratio of the volumes; a
// file of several convex objects, as decompositions write them, is refused where one hull would fill them up.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/result.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::scene {

struct MeshReading {
    bool each_mesh = false;   ///< one hull for each mesh of a file; else one for all
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

/// A single-precision mesh file holds only coordinates that every precision stores exactly, so that the
/// rounding of storage would never show. This map, stated in the report, gives the coordinates all their
/// digits back.
inline constexpr double mesh_scale = 1.0 + 1.0 / 3.0;

/// Returns true if a shape's name is that of a mesh file: built-in ones have no dot and no slash.
[[nodiscard]] inline bool names_mesh_file(std::string_view shape) {
    return shape.find_first_of("./") != shape.npos;
}

/// Throws std::invalid_argument if `as_stored` is set and no shape is a mesh file.
void refuse_as_stored_without_mesh(bool as_stored, std::span<const std::string> shapes);

/// The bodies under the names of their files, scaled by mesh_scale, with new hulls. The warning is that of
/// read_mesh_file.
[[nodiscard]] Result<std::vector<NamedShape>> mesh_shapes(const std::string& file,
                                                          const MeshReading& reading = {});

/// Returns the built-in body of that name, or the first body of mesh_shapes if the name is that of a file.
[[nodiscard]] Result<NamedShape> named_shape(const std::string& name, const MeshReading& reading = {});

}  // namespace edgewise::scene
