// SPDX-License-Identifier: MIT
//
// Volume of a triangle mesh, if it has one.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise::scene {

/// Sum of signed tetrahedra, without its sign; nothing when the mesh is not closed. Closed means: after equal
/// points are welded, every edge is run as often in one direction as in the other (so that the sum depends on
/// no origin).
[[nodiscard]] std::optional<double> mesh_volume(std::span<const Vec3d> points,
                                                std::span<const std::array<Index, 3>> triangles);

}  // namespace edgewise::scene
