// SPDX-License-Identifier: MIT
//
// Vertices in the cells of a grid, each cell with the box around its own: which vertices lie above a plane is
// found by looking into the few boxes that reach above it, not at every vertex for every face.
#pragma once

#include <optional>
#include <vector>

#include "edgewise/geometry/aabb.hpp"
#include "edgewise/geometry/plane.hpp"
#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/vec.hpp"

namespace edgewise {

class VertexBoxes {
  public:
    /// Finite vertices, which must outlive this.
    explicit VertexBoxes(const std::vector<Vec3d>& vertices);

    /// The least index of a vertex whose distance from the plane is not at most `height`, as a look at all of
    /// them would find it, to the bit.
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
