// SPDX-License-Identifier: MIT
//
// As `lean`, with vertex coordinates of 16 bits on the body's own grid: 6.8 bytes per edge at 386 vertices.
// The body is another one: the hull of the vertices where the grid has them, with its own topology; each
// coordinate moves by half a step at most, where a step is the power of two above a 65 533rd of the
// box's longest side (more for a body far off its origin). The precision says what computes.
#pragma once

#include <cstddef>
#include <string_view>

#include "edgewise/geometry/grid.hpp"
#include "edgewise/layout_parts/derived/derived_table.hpp"

namespace edgewise {

/// Coordinates of 16 bits on the body's own grid.
template <class Compute>
struct GridPoints {
    /// What computes with this rounding step holds every place of the grid exactly.
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

    /// What the table holds of a body: the only bodies that it may be built from.
    [[nodiscard]] static Result<Polyhedron> stored_body(const Polyhedron& body) {
        return round_to_grid(body, GridPoints<typename P::Compute>::eps);
    }

    using Base::Base;
};

}  // namespace edgewise
