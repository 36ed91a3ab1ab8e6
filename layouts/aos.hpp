// SPDX-License-Identifier: MIT
//
// Array of structures: the paper's record. One struct an edge with its four Voronoi planes, direction and
// length: 16 + 3 + 1 = 20 scalars; with the edge's share of the vertex coordinates (3 scalars for V/E -> 1/3)
// 21 scalars, 168 bytes in double and 84 in single. Topology, face planes and padding come on top and are
// counted apart.
#pragma once

#include <cstddef>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/rings.hpp"
#include "edgewise/table/voronoi.hpp"

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
class aos {
  public:
    using PrecisionType = P;
    using Stored = typename P::Stored;
    using Compute = typename P::Compute;
    using Vertex = Index;
    using Edge = Index;
    using Face = Index;

    static constexpr Face no_face = edgewise::no_face;
    static constexpr std::string_view name = "aos";
    static constexpr std::string_view stores =
        "one struct an edge: four Voronoi planes, direction, length, ends";
    static constexpr std::string_view derives = "nothing";

    aos(const Polyhedron& body, Parts parts, Loader loader = {}) : loader_(loader) {
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

        block_ = Block(plan);
        facts_ = BodyFacts(body, parts, Tolerance<Stored>::strict_turn);
        vertices_ = block_.fill(vertices, [&](Index v) { return cast<Stored>(body.vertices[v]); });
        edges_ = block_.fill(edges, [&](Index e) { return Record(edge_geometry(body, e), body.edges[e]); });
        faces_ = block_.fill(faces, [&](Index f) { return cast<Stored>(body.face_planes[f]); });
        rings_ = Rings(block_, rings, body);
    }

    /// The same memory seen through another loader.
    template <class OtherLoader>
    aos(const aos<P, OtherLoader>& other, Loader loader)
        : loader_(loader),
          block_(other.block_),
          facts_(other.facts_),
          vertices_(other.vertices_),
          edges_(other.edges_),
          faces_(other.faces_),
          rings_(other.rings_) {}

    [[nodiscard]] std::size_t vertex_count() const { return facts_.vertex_count; }
    [[nodiscard]] Vertex first_vertex() const { return 0; }
    [[nodiscard]] Index index_of(Vertex v) const { return v; }
    [[nodiscard]] auto all_vertices() const { return index_range(facts_.vertex_count); }
    [[nodiscard]] auto all_faces() const { return index_range(facts_.face_count); }
    [[nodiscard]] bool strictly_convex() const { return facts_.strictly_convex; }
    [[nodiscard]] const Ledger& ledger() const { return block_.ledger(); }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(load(vertices_[v], Field::vertex));
    }
    [[nodiscard]] auto neighbours(Vertex v) const { return rings_.neighbours(loader_, v); }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const { return rings_.ring_of_vertex(loader_, v); }
    [[nodiscard]] auto ring_of_face(Face f) const { return rings_.ring_of_face(loader_, f); }

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

    template <class Value>
    const Value& load(const Value& location, Field field) const {
        return loader_.load(location, field);
    }
    [[no_unique_address]] Loader loader_;
    Block block_;
    BodyFacts facts_;
    const Vec3<Stored>* vertices_ = nullptr;
    const Record* edges_ = nullptr;
    const Plane<Stored>* faces_ = nullptr;
    Rings rings_;
};

}  // namespace edgewise
