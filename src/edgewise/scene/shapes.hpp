// SPDX-License-Identifier: MIT
//
// The built-in bodies, by name. All are about 2 m across (radius about 1 m) and centred near the origin:
//   tetra4   regular tetrahedron, edge 1.59 m
//   cube8    cube with 1.125 m edges; faces stay quads, so 12 edges
//   sphereN  triangulated sphere of exactly N vertices, 3N - 6 edges and 2N - 4 faces (sphere_points.hpp)
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/result.hpp"

namespace edgewise::scene {

struct ShapeInfo {
    std::string name;
    std::size_t vertices, edges, faces;
};

/// A body and where it came from.
struct NamedShape {
    std::string name, source;  ///< source: "built-in", or the mesh file's name
    Polyhedron body;
    std::string error;  ///< why there is no body; its cells are unavailable
};

/// The fixed shapes, then both sphere families in order of size.
[[nodiscard]] std::vector<ShapeInfo> list_shapes();

/// An unknown name is an error that lists the known ones; a sphere of a size between two members names both.
[[nodiscard]] Result<Polyhedron> make_shape(std::string_view name);

/// Returns the body at another size. Exact for vertices if the factor has few bits (3/4, 5/4 ...); face
/// normals stay, plane offsets scale.
[[nodiscard]] Polyhedron scaled(const Polyhedron& body, double factor);

}  // namespace edgewise::scene
