// SPDX-License-Identifier: MIT
//
// As `lean`, with vertex coordinates of 16 bits on the body's own grid: 6.8 bytes an edge at 386 vertices.
// The body is another one: the hull of the vertices where the grid has them, with its own topology; each
// coordinate moves by half a step at most, where a step is the power of two at or above a 65 534th of the
// box's longest side (more for a body far off its origin). The precision says what computes.
#pragma once

#include "edgewise/layout_parts/grid_table.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class quantised : public GridTable<quantised<P, Loader>, P, Loader> {
    using Base = GridTable<quantised, P, Loader>;

  public:
    static constexpr std::string_view name = "quantised";
    static constexpr std::string_view stores =
        "vertex coordinates of 16 bits on the body's grid, and neighbour rings of 8, 16 or 32 bits";
    static constexpr std::string_view derives = "edges, faces and every plane";

    /// What the table holds of a body.
    [[nodiscard]] static Result<Polyhedron> stored_body(const Polyhedron& body) {
        return round_to_grid(body, Base::grid_eps);
    }

    /// The body must be a stored_body.
    quantised(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(body, parts, loader) {}

    /// The same memory seen through another loader.
    template <class OtherLoader>
    quantised(const quantised<P, OtherLoader>& other, Loader loader) : Base(other, loader) {}
};

}  // namespace edgewise
