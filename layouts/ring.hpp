// SPDX-License-Identifier: MIT
//
// Voronoi planes in the order of the rings: the vertex-edge planes around a vertex lie side by side, and so
// do the edge-face planes around a face. One pass over contiguous memory finds the plane of a ring that a
// point violates most: no edge is read and no index followed until the winner is known. Slopes of a vertex's
// edges are a pass over the same planes: the reversed normals are the directions that leave it. Every
// half-edge starts at one vertex and has one face on its left, so each plane is kept once.
//
// Per edge four planes, as in `aos` (128 bytes in double, 64 in single), and a record of its own: ends,
// direction and length, and the places of its planes (64 bytes, 48 in single), 16 bytes more than `aos`. The
// price: a plane asked for by its edge, as tests of a single edge do, costs one more read and another line.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

#include "edgewise/layout_parts/stored_table.hpp"
#include "edgewise/table/ring_questions.hpp"

namespace edgewise {

/// The record of one edge.
template <class Stored>
struct RingRecord {
    Index vertex_edge_at[2], edge_face_at[2];  // by End, by Side
    PolyhedronEdge ends;
    Vec3<Stored> direction;
    Stored length;
};

template <class Stored>
struct RingArrays {
    Vec3<Stored>* vertices = nullptr;
    Plane<Stored>* vertex_edge = nullptr;  // ring after ring, as in Rings::vertex_ring
    Plane<Stored>* edge_face =
        nullptr;  // ring after ring, as in Rings::face_ring; last, those without a face
    RingRecord<Stored>* edges = nullptr;
    Plane<Stored>* faces = nullptr;

    void place(BlockPlan& plan, const BodyFacts& n) {
        const Shares plane = {{Component::voronoi_planes, sizeof(Plane<Stored>)}};
        plan.array(vertices, n.vertex_count, {{Component::vertex_coordinates, sizeof(Vec3<Stored>)}});
        plan.array(vertex_edge, 2 * std::size_t{n.edge_count()}, plane);
        plan.array(edge_face, 2 * std::size_t{n.edge_count()}, plane);
        plan.array(
            edges, n.edge_count(),
            {{Component::topology, 8 * sizeof(Index)}, {Component::edge_geometry, 4 * sizeof(Stored)}});
        plan.array(faces, n.face_count, {{Component::face_planes, sizeof(Plane<Stored>)}});
    }

    [[nodiscard]] auto& vertex(Index v) const { return vertices[v]; }
    [[nodiscard]] auto& direction(Index e) const { return edges[e].direction; }
    [[nodiscard]] auto& ends(Index e) const { return edges[e].ends; }
    [[nodiscard]] auto& face_plane(Index f) const { return faces[f]; }

    void write_edge(Index e, const EdgeGeometry& g) const {
        RingRecord<Stored>& edge = edges[e];
        vertex_edge[edge.vertex_edge_at[0]] = cast<Stored>(g.tail_plane);
        vertex_edge[edge.vertex_edge_at[1]] = cast<Stored>(g.head_plane);
        edge_face[edge.edge_face_at[0]] = cast<Stored>(g.left_plane);
        edge_face[edge.edge_face_at[1]] = cast<Stored>(g.right_plane);
        edge.direction = cast<Stored>(g.direction);
        edge.length = static_cast<Stored>(g.length);
    }

    /// Sets the places of each edge's planes.
    void link(const Polyhedron& body) const {
        for (Index at = 0; at < body.vertex_ring.size(); ++at) {
            const HalfEdge h = body.vertex_ring[at];
            edges[h >> 1].vertex_edge_at[h & 1] = at;
        }
        Index last = 0;
        for (const HalfEdge h : body.face_ring) edges[h >> 1].edge_face_at[h & 1] = last++;
        for (HalfEdge h = 0; h < 2 * body.edge_count(); ++h) {
            if (body.face(h) == no_face) edges[h >> 1].edge_face_at[h & 1] = last++;
        }
    }
};

template <Precision P, class Loader = Direct>
class ring : public StoredTable<RingArrays<typename P::Stored>, P, Loader> {
    using Base = StoredTable<RingArrays<typename P::Stored>, P, Loader>;
    using Base::load, Base::rings_;

  protected:
    using Base::at_;

  public:
    using typename Base::Compute, typename Base::Edge, typename Base::Face, typename Base::Stored,
        typename Base::Vertex;

    static constexpr std::string_view name = "ring";
    static constexpr std::string_view stores =
        "Voronoi planes in ring order; one struct per edge: ends, places of its planes, direction, length";

    using Base::Base;

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        assert(e < this->facts_.edge_count());
        const Index at = load(at_.edges[e].vertex_edge_at[static_cast<int>(end)], Field::vertex_ring);
        return cast<Compute>(load(at_.vertex_edge[at], Field::voronoi_plane));
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        assert(e < this->facts_.edge_count());
        const Index at = load(at_.edges[e].edge_face_at[static_cast<int>(side)], Field::face_ring);
        return cast<Compute>(load(at_.edge_face[at], Field::voronoi_plane));
    }

    /// Answers in one pass, as table/ring_questions.hpp allows.
    [[nodiscard]] std::optional<Edge> most_violated_vertex_plane(Vertex v, const Vec3<Compute>& point) const {
        return most_violated(at_.vertex_edge, rings_.vertex_ring, rings_.vertex_offset + v,
                             Field::vertex_ring, point);
    }
    [[nodiscard]] std::optional<Edge> most_violated_face_side(Face f, const Vec3<Compute>& point) const {
        return most_violated(at_.edge_face, rings_.face_ring, rings_.face_offset + f, Field::face_ring,
                             point);
    }
    [[nodiscard]] auto steepest_descent(Vertex v, const Vec3<Compute>& normal) const {
        const Index first = load(rings_.vertex_offset[v], Field::vertex_ring);
        const Index last = load(rings_.vertex_offset[v + 1], Field::vertex_ring);
        Descent<Edge, Compute> result;
        Index worst = last;
        for (Index at = first; at < last; ++at) {
            const auto backwards = cast<Compute>(load(at_.vertex_edge[at].normal, Field::voronoi_plane));
            const Compute slope = -squared_slope(dot(backwards, normal));
            result.steepest = std::max(result.steepest, std::abs(slope));
            worst = slope < result.slope ? at : worst;
            result.slope = std::min(result.slope, slope);
        }
        if (worst != last) result.edge = load(rings_.vertex_ring[worst], Field::vertex_ring) >> 1;
        return result;
    }

  private:
    /// Selects instead of jumps, so that nothing delays the distances of the planes that follow. Not in
    /// vectors: the n x, n y, n z and n offsets of a ring in rows, four planes a vector operation, took 1.09
    /// (double; 1.00 single) of the time of `aos` where this takes 0.94 (0.91; V-Clip, `cold`, 386 vertices).
    /// Rings of three and six planes fill vectors badly, and the search for the least takes as long.
    std::optional<Edge> most_violated(const Plane<Stored>* planes, const Index* half_edges,
                                      const Index* offset, Field field, const Vec3<Compute>& point) const {
        const Index first = load(offset[0], field), last = load(offset[1], field);
        Index worst = last;
        Compute least = 0;
        for (Index at = first; at < last; ++at) {
            const Compute d = cast<Compute>(load(planes[at], Field::voronoi_plane)).distance(point);
            worst = d < least ? at : worst;
            least = d < least ? d : least;
        }
        if (worst == last) return std::nullopt;
        return load(half_edges[worst], field) >> 1;
    }
};

}  // namespace edgewise
