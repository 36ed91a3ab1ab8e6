// SPDX-License-Identifier: MIT
//
// Array of structures: one record an edge, with everything a test may ask of it. For layouts that differ in
// the record alone. A record gives the members vertex_edge[2] (by End), edge_face[2] (by Side), direction,
// length, ends; and what its bytes are for, in memory order, as shares().
#pragma once

#include "edgewise/table/vertex_face_table.hpp"

namespace edgewise {

template <Precision P, class Loader, class Record>
class RecordTable : public VertexFaceTable<P, Loader> {
    using Base = VertexFaceTable<P, Loader>;

  protected:
    using Base::block_;
    using Base::load;

  public:
    using typename Base::Compute;
    using typename Base::Edge;
    using typename Base::Face;
    using typename Base::Stored;
    using typename Base::Vertex;

    [[nodiscard]] Vertex tail(Edge e) const { return load(edges_[e].ends.tail, Field::edge_ends); }
    [[nodiscard]] Vertex head(Edge e) const { return load(edges_[e].ends.head, Field::edge_ends); }
    [[nodiscard]] Face left(Edge e) const { return load(edges_[e].ends.left, Field::edge_ends); }
    [[nodiscard]] Face right(Edge e) const { return load(edges_[e].ends.right, Field::edge_ends); }
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        return cast<Compute>(load(edges_[e].direction, Field::edge_direction));
    }
    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        return cast<Compute>(load(edges_[e].vertex_edge[static_cast<int>(end)], Field::voronoi_plane));
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        return cast<Compute>(load(edges_[e].edge_face[static_cast<int>(side)], Field::voronoi_plane));
    }

    void write_edge(Index e, const EdgeGeometry& g) {
        Record& edge = edges_[e];
        edge.vertex_edge[0] = cast<Stored>(g.tail_plane);
        edge.vertex_edge[1] = cast<Stored>(g.head_plane);
        edge.edge_face[0] = cast<Stored>(g.left_plane);
        edge.edge_face[1] = cast<Stored>(g.right_plane);
        edge.direction = cast<Stored>(g.direction);
        edge.length = static_cast<Stored>(g.length);
    }

  protected:
    template <Precision, class, class>
    friend class RecordTable;

    RecordTable(const Polyhedron& body, Parts parts, Loader loader, WriteEdges write) : Base(loader) {
        Slot<Record> edges{};
        this->build(body, parts, [&](BlockPlan& plan) {
            edges = plan.array<Record>(Base::edges_of(body, parts), Record::shares());
        });
        edges_ = block_.start(edges);
        for (std::size_t e = 0; e < edges.count; ++e) edges_[e].ends = body.edges[e];
        write_geometry(*this, body, write);
    }
    template <class OtherLoader>
    RecordTable(const RecordTable<P, OtherLoader, Record>& other, Loader loader)
        : Base(other, loader), edges_(other.edges_) {}

  private:
    Record* edges_ = nullptr;
};

}  // namespace edgewise
