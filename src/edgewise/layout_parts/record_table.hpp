// SPDX-License-Identifier: MIT
//
// Array of structures: one record an edge, with everything a test may ask of it. For layouts that differ in
// the record alone. A record gives the members vertex_edge[2] (by End), edge_face[2] (by Side), direction,
// length, ends; and what its bytes are for, in memory order, as shares().
#pragma once

#include "edgewise/layout_parts/edge_records.hpp"

namespace edgewise {

template <Precision P, class Loader, class Record>
class RecordTable : public EdgeRecords<P, Loader, Record> {
    using Base = EdgeRecords<P, Loader, Record>;

    using Base::edges_;
    using Base::load;

  public:
    using typename Base::Compute;
    using typename Base::Edge;
    using typename Base::Stored;

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
    RecordTable(const Polyhedron& body, Parts parts, Loader loader, WriteEdges write) : Base(loader) {
        Slot<Record> edges{};
        this->build(body, parts, [&](BlockPlan& plan) {
            edges = plan.array<Record>(Base::edges_of(body, parts), Record::shares());
        });
        this->start_edges(edges, body);
        write_geometry(*this, body, write);
    }
    template <class OtherLoader>
    RecordTable(const RecordTable<P, OtherLoader, Record>& other, Loader loader) : Base(other, loader) {}
};

}  // namespace edgewise
