// SPDX-License-Identifier: MIT
//
// The convex polyhedron of parry (revision 3a41ac21, shape/convex_polyhedron.rs): points; for each vertex
// and each face the start and length of its part of the adjacency lists; faces with their normals; edges
// with ends, faces, direction and a flag, 32 bytes in single and 48 in double; and four lists of 32-bit
// indices, faces and edges of vertices, edges and vertices of faces. 84 bytes per edge in single, 112 in
// double. Only the structure is the library's, from its published list of fields; the algorithms are
// ours.
//
// A scan over the points finds support points, as in the library. V-Clip finds all that it needs except
// planes, which are derived from directions, normals and points. Lists are in cyclic order, as in every table
// here. Everything is always stored, also in a table for GJK (keeps_faces, table/contract.hpp).
#pragma once

#include <cassert>
#include <cstdint>
#include <string_view>

#include "edgewise/layout_parts/block_table.hpp"
#include "edgewise/layout_parts/voronoi.hpp"

namespace edgewise {

/// A range in two adjacency lists.
struct ParryRange {
    Index first, count;
};

template <class Stored>
struct ParryFace {
    ParryRange around;
    Vec3<Stored> normal;
};

template <class Stored>
struct ParryEdge {
    Index vertices[2], faces[2];  ///< tail and head; left and right, or no_face
    Vec3<Stored> direction;
    bool deleted;  ///< flag of the library's builder: always false
};

/// The start of each array, in bytes from the block's start.
template <class Stored>
struct ParryPlaces {
    using Face = ParryFace<Stored>;
    using Edge = ParryEdge<Stored>;

    std::uint32_t points = 0, vertices = 0, faces = 0, edges = 0;
    std::uint32_t faces_of_vertex = 0, edges_of_vertex = 0, edges_of_face = 0, vertices_of_face = 0;

    void place(BlockPlan& plan, const BodyFacts& n) {
        const Shares index = {{Component::topology, sizeof(Index)}};
        points = plan.array_at<Vec3<Stored>>(n.vertex_count,
                                             {{Component::vertex_coordinates, sizeof(Vec3<Stored>)}});
        vertices = plan.array_at<ParryRange>(n.vertex_count, {{Component::topology, sizeof(ParryRange)}});
        faces = plan.array_at<Face>(n.face_count, {{Component::topology, sizeof(ParryRange)},
                                                   {Component::face_planes, sizeof(Vec3<Stored>)}});
        edges = plan.array_at<Edge>(n.edge_count(), {{Component::topology, 4 * sizeof(Index)},
                                                     {Component::edge_geometry, sizeof(Vec3<Stored>)}});
        faces_of_vertex = plan.array_at<Index>(n.face_ring_count(), index);
        edges_of_vertex = plan.array_at<Index>(n.neighbour_count, index);
        edges_of_face = plan.array_at<Index>(n.face_ring_count(), index);
        vertices_of_face = plan.array_at<Index>(n.face_ring_count(), index);
    }
};

template <Precision P, class Loader = Direct>
class parry : public WithNumberedFeatures<PlacedTable<ParryPlaces<typename P::Stored>, P, Loader>> {
    using Base = WithNumberedFeatures<PlacedTable<ParryPlaces<typename P::Stored>, P, Loader>>;
    using Base::facts_, Base::load, Base::places_;

  public:
    using typename Base::Compute, typename Base::Edge, typename Base::Face, typename Base::Stored,
        typename Base::Vertex;

    static constexpr std::string_view name = "parry";
    static constexpr std::string_view stores =
        "parry's polyhedron (3a41ac21): points, edges, faces, four adjacency lists of 32 bits";
    static constexpr std::string_view derives = "planes of edges; support points, by scans";
    static constexpr bool keeps_faces = true;

    /// Both kinds of parts are the same here: the library keeps everything.
    parry(const Polyhedron& body, Parts /*parts*/, Loader loader = {}) : Base(body, Parts::features, loader) {
        link_vertices(body);
        link_faces(body);
        for (Index e = 0; e < facts_.edge_count(); ++e) {
            const PolyhedronEdge& ends = body.edges[e];
            edges()[e] = {{ends.tail, ends.head}, {ends.left, ends.right}, {}, false};
        }
        write_geometry(*this, body);
    }

    using Base::Base;

    void write_vertex(Index v, const Vec3d& point) { points()[v] = cast<Stored>(point); }
    void write_edge(Index e, const EdgeGeometry& g) { edges()[e].direction = cast<Stored>(g.direction); }
    void write_face(Index f, const Plane<double>& plane) { faces()[f].normal = cast<Stored>(plane.normal); }

    /// Always false: the library scans.
    [[nodiscard]] static bool climbable() { return false; }

    [[nodiscard]] auto neighbours(Vertex v) const {
        const ParryRange part = load(vertices()[v], Field::vertex_ring);
        return IndexedRing(part.first, part.first + part.count, [this, v](Index at) {
            const auto& ends = edges()[load(list(places_.edges_of_vertex)[at], Field::vertex_ring)].vertices;
            const Index tail = load(ends[0], Field::neighbour);
            return tail == v ? load(ends[1], Field::neighbour) : tail;
        });
    }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const {
        const ParryRange part = load(vertices()[v], Field::vertex_ring);
        return IndexedRing(part.first, part.first + part.count, [this, v](Index at) {
            const Edge e = load(list(places_.edges_of_vertex)[at], Field::vertex_ring);
            return RingEdge<Edge>{e, head(e) == v};
        });
    }
    [[nodiscard]] auto ring_of_face(Face f) const {
        assert(f < facts_.face_count);
        const ParryRange part = load(faces()[f].around, Field::face_ring);
        return IndexedRing(part.first, part.first + part.count, [this, f](Index at) {
            const Edge e = load(list(places_.edges_of_face)[at], Field::face_ring);
            return RingEdge<Edge>{e, right(e) == f};
        });
    }

    [[nodiscard]] Vertex tail(Edge e) const { return load(edges()[e].vertices[0], Field::edge_ends); }
    [[nodiscard]] Vertex head(Edge e) const { return load(edges()[e].vertices[1], Field::edge_ends); }
    [[nodiscard]] Face left(Edge e) const { return load(edges()[e].faces[0], Field::edge_ends); }
    [[nodiscard]] Face right(Edge e) const { return load(edges()[e].faces[1], Field::edge_ends); }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        return cast<Compute>(load(points()[v], Field::vertex));
    }
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        assert(e < facts_.edge_count());
        return cast<Compute>(load(edges()[e].direction, Field::edge_direction));
    }
    [[nodiscard]] AnchoredPlane<Compute> vertex_edge_plane(Edge e, End end) const {
        return plane_beyond(end, direction(e), vertex(end == End::tail ? tail(e) : head(e)));
    }
    [[nodiscard]] AnchoredPlane<Compute> edge_face_plane(Edge e, Side side) const {
        const Vec3<Compute> at_tail = vertex(tail(e));
        const Face face = side == Side::left ? left(e) : right(e);
        if (face == no_face) return plane_beside_nothing(at_tail);
        return plane_beside(side, direction(e), normal(face), at_tail);
    }
    [[nodiscard]] AnchoredPlane<Compute> face_plane(Face f) const {
        const Index first = load(faces()[f].around.first, Field::face_ring);
        return {normal(f), vertex(load(list(places_.vertices_of_face)[first], Field::face_ring))};
    }

  private:
    using Places = ParryPlaces<Stored>;

    void link_vertices(const Polyhedron& body) const {
        for (Index v = 0; v < facts_.vertex_count; ++v)
            vertices()[v] = {body.vertex_offset[v], body.vertex_offset[v + 1] - body.vertex_offset[v]};
        for (Index at = 0; at < facts_.neighbour_count; ++at) {
            const HalfEdge h = body.vertex_ring[at];
            list(places_.edges_of_vertex)[at] = h >> 1;
            if (facts_.face_count > 0) list(places_.faces_of_vertex)[at] = body.face(h);
        }
    }
    void link_faces(const Polyhedron& body) const {
        for (Index f = 0; f < facts_.face_count; ++f)
            faces()[f].around = {body.face_offset[f], body.face_offset[f + 1] - body.face_offset[f]};
        for (Index at = 0; at < facts_.face_ring_count(); ++at) {
            list(places_.edges_of_face)[at] = body.face_ring[at] >> 1;
            list(places_.vertices_of_face)[at] = body.tail(body.face_ring[at]);
        }
    }

    [[nodiscard]] Vec3<Compute> normal(Face f) const {
        assert(f < facts_.face_count);
        return cast<Compute>(load(faces()[f].normal, Field::face_plane));
    }
    [[nodiscard]] auto* points() const { return this->template array<Vec3<Stored>>(places_.points); }
    [[nodiscard]] ParryRange* vertices() const { return this->template array<ParryRange>(places_.vertices); }
    [[nodiscard]] auto* faces() const { return this->template array<ParryFace<Stored>>(places_.faces); }
    [[nodiscard]] auto* edges() const { return this->template array<ParryEdge<Stored>>(places_.edges); }
    [[nodiscard]] Index* list(std::uint32_t at) const { return this->template array<Index>(at); }
};

}  // namespace edgewise
