// SPDX-License-Identifier: MIT
//
// What layouts have in common that keep a struct an edge: an array of them, of which the ends and the
// direction are read. A record gives the members ends and direction; where planes are is the layout's own.
#pragma once

#include "edgewise/layout_parts/vertex_face_table.hpp"

namespace edgewise {

template <Precision P, class Loader, class Record>
class EdgeRecords : public VertexFaceTable<P, Loader> {
    using Base = VertexFaceTable<P, Loader>;

  protected:
    using Base::block_;
    using Base::load;

  public:
    using typename Base::Compute;
    using typename Base::Edge;
    using typename Base::Face;
    using typename Base::Vertex;

    [[nodiscard]] Vertex tail(Edge e) const { return load(edges_[e].ends.tail, Field::edge_ends); }
    [[nodiscard]] Vertex head(Edge e) const { return load(edges_[e].ends.head, Field::edge_ends); }
    [[nodiscard]] Face left(Edge e) const { return load(edges_[e].ends.left, Field::edge_ends); }
    [[nodiscard]] Face right(Edge e) const { return load(edges_[e].ends.right, Field::edge_ends); }
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        return cast<Compute>(load(edges_[e].direction, Field::edge_direction));
    }

  protected:
    template <Precision, class, class>
    friend class EdgeRecords;

    explicit EdgeRecords(Loader loader) : Base(loader) {}
    template <class OtherLoader>
    EdgeRecords(const EdgeRecords<P, OtherLoader, Record>& other, Loader loader)
        : Base(other, loader), edges_(other.edges_) {}

    /// Begins the planned records and writes their ends.
    void start_edges(Slot<Record> slot, const Polyhedron& body) {
        edges_ = block_.start(slot);
        for (std::size_t e = 0; e < slot.count; ++e) edges_[e].ends = body.edges[e];
    }

    Record* edges_ = nullptr;
};

}  // namespace edgewise
