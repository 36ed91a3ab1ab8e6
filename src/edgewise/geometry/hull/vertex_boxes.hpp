// SPDX-License-Identifier: MIT
//
// Vertices in the cells of a grid, each cell with the box around its own vertices. A search for vertices
// above a plane opens the few boxes that reach above it, instead of testing every vertex for every face.
#pragma once

#include <optional>
#include <vector>

#include "edgewise/geometry/aabb.hpp"
#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/vec.hpp"

namespace edgewise {

class VertexBoxes {
  public:
    /// Holds a reference to these vertices, which must be finite and outlive this object.
    explicit VertexBoxes(const std::vector<Vec3d>& vertices);

    /// Returns the least index of a vertex with a distance from the plane that is not at most `height`: the
    /// index that a scan of all vertices returns, to the bit.
    [[nodiscard]] std::optional<Index> first_above(const Plane<double>& plane, double height) const;

  private:
    struct Cell {
        Aabb box;
        std::vector<Index> vertices;
    };

    const std::vector<Vec3d>& vertices_;
    double rounding_;  // bound of what a distance and a box's reach are off
    std::vector<Cell> cells_;
};

}  // namespace edgewise
