// SPDX-License-Identifier: MIT
//
// Derived planes over coordinates of 16 bits on the body's own grid. For layouts that differ in which body
// they hold of a given one.
#pragma once

#include "edgewise/geometry/grid.hpp"
#include "edgewise/layout_parts/derived_table.hpp"

namespace edgewise {

/// Table: the layout.
template <class Table, Precision P, class Loader>
class GridTable : public DerivedTable<Table, P, Loader> {
    using Base = DerivedTable<Table, P, Loader>;

  public:
    using typename Base::Compute;
    using typename Base::Vertex;

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(grid_.at(this->load(vertices_[v], Field::vertex)));
    }

    /// The grid is the body's own.
    void write_body(const Polyhedron& body) {
        grid_ = Grid(body.vertices, grid_eps);
        for (Index v = 0; v < body.vertex_count(); ++v) vertices_[v] = grid_.nearest(body.vertices[v]);
    }

  protected:
    template <class, Precision, class>
    friend class GridTable;

    /// What computes with this rounding step holds every place of the grid exactly.
    static constexpr double grid_eps = double{Tolerance<Compute>::eps};

    GridTable(const Polyhedron& body, Parts parts, Loader loader)
        : Base(loader), vertices_(this->template build<Grid::Place>(body, parts)) {
        write_body(body);
    }
    template <class OtherTable, class OtherLoader>
    GridTable(const GridTable<OtherTable, P, OtherLoader>& other, Loader loader)
        : Base(other, loader), grid_(other.grid_), vertices_(other.vertices_) {}

  private:
    Grid grid_;
    Grid::Place* vertices_ = nullptr;
};

}  // namespace edgewise
