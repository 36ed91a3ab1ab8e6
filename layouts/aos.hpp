// SPDX-License-Identifier: MIT
//
// Array of structures: the paper's record. One struct an edge with its four Voronoi planes, direction and
// length: 16 + 3 + 1 = 20 scalars; with the edge's share of the vertex coordinates (3 scalars for V/E -> 1/3)
// 21 scalars, 168 bytes in double and 84 in single. Topology, face planes and padding come on top and are
// counted apart.
#pragma once

#include "edgewise/table/indexed_table.hpp"

namespace edgewise {

/// The record of one edge.
template <class Stored>
struct AosRecord {
    Plane<Stored> vertex_edge[2];  // by End
    Plane<Stored> edge_face[2];    // by Side
    Vec3<Stored> direction;
    Stored length;
    PolyhedronEdge ends;

    AosRecord(const EdgeGeometry& g, const PolyhedronEdge& e)
        : vertex_edge{cast<Stored>(g.tail_plane), cast<Stored>(g.head_plane)},
          edge_face{cast<Stored>(g.left_plane), cast<Stored>(g.right_plane)},
          direction(cast<Stored>(g.direction)),
          length(static_cast<Stored>(g.length)),
          ends(e) {}
};

template <Precision P, class Loader = Direct>
class aos : public IndexedTable<P, Loader> {
    using Base = IndexedTable<P, Loader>;
    using Base::block_;
    using Base::load;

  public:
    using typename Base::Compute;
    using typename Base::Edge;
    using typename Base::Face;
    using typename Base::Stored;
    using typename Base::Vertex;

    static constexpr std::string_view name = "aos";
    static constexpr std::string_view stores =
        "one struct an edge: four Voronoi planes, direction, length, ends";
    static constexpr std::string_view derives = "nothing";

    aos(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(loader) {
        const bool features = parts == Parts::features;
        BlockPlan plan;
        const auto vertices = plan.array<Vec3<Stored>>(
            body.vertex_count(), {{Component::vertex_coordinates, sizeof(Vec3<Stored>)}});
        const auto edges = plan.array<Record>(features ? body.edge_count() : 0,
                                              {{Component::voronoi_planes, 4 * sizeof(Plane<Stored>)},
                                               {Component::edge_geometry, 4 * sizeof(Stored)},
                                               {Component::topology, 4 * sizeof(Index)}});
        const auto faces = plan.array<Plane<Stored>>(features ? body.face_count() : 0,
                                                     {{Component::face_planes, sizeof(Plane<Stored>)}});
        const RingSlots rings(plan, body, parts);

        this->allocate(plan, body, parts);
        vertices_ = block_.fill(vertices, [&](Index v) { return cast<Stored>(body.vertices[v]); });
        edges_ = block_.fill(edges, [&](Index e) { return Record(edge_geometry(body, e), body.edges[e]); });
        faces_ = block_.fill(faces, [&](Index f) { return cast<Stored>(body.face_planes[f]); });
        this->rings_ = Rings(block_, rings, body);
    }

    /// The same memory seen through another loader.
    template <class OtherLoader>
    aos(const aos<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), vertices_(other.vertices_), edges_(other.edges_), faces_(other.faces_) {}

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(load(vertices_[v], Field::vertex));
    }

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
    [[nodiscard]] Plane<Compute> face_plane(Face f) const {
        return cast<Compute>(load(faces_[f], Field::face_plane));
    }

  private:
    template <Precision, class>
    friend class aos;

    using Record = AosRecord<Stored>;

    const Vec3<Stored>* vertices_ = nullptr;
    const Record* edges_ = nullptr;
    const Plane<Stored>* faces_ = nullptr;
};

}  // namespace edgewise
