// SPDX-License-Identifier: MIT
//
// The table of `lean` with vertex coordinates of 16 bits on the body's own grid: 6.8 bytes per edge at 386
// vertices. The stored body differs: it is the hull of the vertices at their grid places, with its own
// topology; each coordinate moves by half a step at most, where a step is the power of two above a 65 533rd
// of the box's longest side (more for a body far off its origin). The precision is the one that computes.
#pragma once

#include <cstddef>
#include <string_view>

#include "edgewise/geometry/grid.hpp"
#include "edgewise/layout_parts/derived/derived_table.hpp"

namespace edgewise {

/// Vertex coordinates of 16 bits on the body's own grid.
template <class Compute>
struct GridPoints {
    /// Arithmetic with this rounding step holds every place of the grid exactly.
    static constexpr double eps = double{Tolerance<Compute>::eps};

    Grid grid;

    static void place(BlockPlan& plan, const BodyFacts& n) {
        plan.array_at<Grid::Place>(n.vertex_count, {{Component::vertex_coordinates, sizeof(Grid::Place)}});
    }
    void write(std::byte* base, const Polyhedron& body) {
        auto* const points = reinterpret_cast<Grid::Place*>(base);
        grid = Grid::of_rounded(body.vertices, eps);
        for (Index v = 0; v < body.vertex_count(); ++v) points[v] = grid.nearest(body.vertices[v]);
    }
    template <class Loader>
    [[nodiscard]] Vec3d read(const Loader& loader, const std::byte* base, Index v) const {
        return grid.at(loader.load(reinterpret_cast<const Grid::Place*>(base)[v], Field::vertex));
    }
};

template <Precision P, class Loader = Direct>
class quantised : public DerivedTable<GridPoints<typename P::Compute>, P, Loader> {
    using Base = DerivedTable<GridPoints<typename P::Compute>, P, Loader>;

  public:
    static constexpr std::string_view name = "quantised";
    static constexpr std::string_view stores =
        "vertex coordinates of 16 bits on the body's grid, and neighbour rings of 8, 16 or 32 bits";

    /// The body as the table holds it: the only kind of body that it may be built from.
    [[nodiscard]] static Result<Polyhedron> stored_body(const Polyhedron& body) {
        return round_to_grid(body, GridPoints<typename P::Compute>::eps);
    }

    using Base::Base;
};

}  // namespace edgewise
