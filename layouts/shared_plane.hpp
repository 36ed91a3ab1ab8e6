// SPDX-License-Identifier: MIT
//
// The record of `aos` without what it says twice. Both vertex-edge planes of an edge stand across its
// direction d: the tail's is {-d, offset}, the head's {d, offset}. So d is kept once and turned round for the
// tail, which is exact; both offsets are kept, and every plane is that of `aos` to the bit. Nothing asks for
// the length: it is left out.
//
// The edge-face planes could be had from direction and face normal too, but not to the bit: they stay.
//
// Per edge 13 scalars instead of 20: d (3, counted as edge geometry, although it is the normal of two planes
// as well), two offsets and two edge-face planes (10, counted as Voronoi planes). With four indices that is
// 120 bytes in double instead of 176, 68 in single instead of 96; neither needs padding. The head's plane is
// one piece of memory, the tail's two neighbouring ones.
#pragma once

#include "edgewise/table/vertex_face_table.hpp"

namespace edgewise {

/// The record of one edge.
template <class Stored>
struct SharedPlaneRecord {
    Stored tail_offset;
    Vec3<Stored> direction;  // the head plane's normal, and the tail plane's turned round
    Stored head_offset;
    Plane<Stored> edge_face[2];  // by Side
    PolyhedronEdge ends;
};

template <Precision P, class Loader = Direct>
class shared_plane : public VertexFaceTable<P, Loader> {
    using Base = VertexFaceTable<P, Loader>;
    using Base::block_;
    using Base::load;

  public:
    using typename Base::Compute;
    using typename Base::Edge;
    using typename Base::Face;
    using typename Base::Stored;
    using typename Base::Vertex;

    static constexpr std::string_view name = "shared_plane";
    static constexpr std::string_view relative_of = "aos";
    static constexpr std::string_view stores =
        "one struct an edge: direction, two vertex-edge offsets, two edge-face planes, ends";
    static constexpr std::string_view derives =
        "normals of vertex-edge planes, from the direction; no length";

    shared_plane(const Polyhedron& body, Parts parts, Loader loader = {}, WriteEdges write = WriteEdges::now)
        : Base(loader) {
        Slot<Record> edges{};
        this->build(body, parts, [&](BlockPlan& plan) {
            edges =
                plan.array<Record>(Base::edges_of(body, parts),
                                   {{Component::voronoi_planes, sizeof(Stored)},
                                    {Component::edge_geometry, sizeof(Vec3<Stored>)},
                                    {Component::voronoi_planes, sizeof(Stored) + 2 * sizeof(Plane<Stored>)},
                                    {Component::topology, 4 * sizeof(Index)}});
        });
        edges_ = block_.start(edges);
        for (std::size_t e = 0; e < edges.count; ++e) edges_[e].ends = body.edges[e];
        write_geometry(*this, body, write);
    }

    /// The same memory seen through another loader.
    template <class OtherLoader>
    shared_plane(const shared_plane<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), edges_(other.edges_) {}

    [[nodiscard]] Vertex tail(Edge e) const { return load(edges_[e].ends.tail, Field::edge_ends); }
    [[nodiscard]] Vertex head(Edge e) const { return load(edges_[e].ends.head, Field::edge_ends); }
    [[nodiscard]] Face left(Edge e) const { return load(edges_[e].ends.left, Field::edge_ends); }
    [[nodiscard]] Face right(Edge e) const { return load(edges_[e].ends.right, Field::edge_ends); }
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        return cast<Compute>(load(edges_[e].direction, Field::edge_direction));
    }

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        const Record& edge = edges_[e];
        const auto along = cast<Compute>(load(edge.direction, Field::voronoi_plane));
        if (end == End::head) return {along, load(edge.head_offset, Field::voronoi_plane)};
        return {-along, load(edge.tail_offset, Field::voronoi_plane)};
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        return cast<Compute>(load(edges_[e].edge_face[static_cast<int>(side)], Field::voronoi_plane));
    }

    void write_edge(Index e, const EdgeGeometry& g) {
        Record& edge = edges_[e];
        edge.tail_offset = static_cast<Stored>(g.tail_plane.offset);
        edge.direction = cast<Stored>(g.direction);
        edge.head_offset = static_cast<Stored>(g.head_plane.offset);
        edge.edge_face[0] = cast<Stored>(g.left_plane);
        edge.edge_face[1] = cast<Stored>(g.right_plane);
    }

  private:
    template <Precision, class>
    friend class shared_plane;

    using Record = SharedPlaneRecord<Stored>;

    Record* edges_ = nullptr;
};

}  // namespace edgewise
