// SPDX-License-Identifier: MIT
//
// As `lean`, with vertex coordinates of 16 bits on the body's own grid: 6.7 bytes an edge at 386 vertices.
// The body is another one: the hull of the vertices where the grid has them, with its own topology; each
// coordinate moves by half a step at most, 2^-16 of the box's longest side. The precision says what computes.
#pragma once

#include "edgewise/geometry/grid.hpp"
#include "edgewise/table/derived_table.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class quantised : public DerivedTable<quantised<P, Loader>, P, Loader> {
    using Base = DerivedTable<quantised, P, Loader>;
    using Base::block_;

  public:
    using typename Base::Compute;
    using typename Base::Vertex;

    static constexpr std::string_view name = "quantised";
    static constexpr std::string_view stores =
        "vertex coordinates of 16 bits on the body's grid, and neighbour rings of 8, 16 or 32 bits";
    static constexpr std::string_view derives = "edges, faces and every plane";

    /// What the table holds of a body.
    [[nodiscard]] static Result<Polyhedron> stored_body(const Polyhedron& body) {
        return round_to_grid(body, double{Tolerance<Compute>::eps});
    }

    /// The body must be a stored_body.
    quantised(const Polyhedron& body, Parts parts, Loader loader = {})
        : Base(loader), grid_(body.vertices, double{Tolerance<Compute>::eps}) {
        BlockPlan plan;
        const auto vertices = plan.array<Grid::Place>(body.vertex_count(),
                                                      {{Component::vertex_coordinates, sizeof(Grid::Place)}});
        this->rings_ = NarrowRings(plan, body);
        block_ = Block(plan);
        this->facts_ = BodyFacts(body, parts, Tolerance<Compute>::strict_turn);
        vertices_ = block_.fill(vertices, [&](Index v) { return grid_.nearest(body.vertices[v]); });
        this->rings_.fill(block_, body);
    }

    /// The same memory seen through another loader.
    template <class OtherLoader>
    quantised(const quantised<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), grid_(other.grid_), vertices_(other.vertices_) {}

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(grid_.at(this->loader_.load(vertices_[v], Field::vertex)));
    }

  private:
    template <Precision, class>
    friend class quantised;

    Grid grid_;
    const Grid::Place* vertices_ = nullptr;
};

}  // namespace edgewise
