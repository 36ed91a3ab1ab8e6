// SPDX-License-Identifier: MIT
//
// Voronoi planes in the order of the rings: the vertex-edge planes around a vertex lie side by side, and so
// do the edge-face planes around a face. Which plane of a ring a point violates most is then one pass over
// contiguous memory: no edge is read and no index followed until the winner is known. The slopes of the edges
// at a vertex are a pass over the same planes, whose normals are the directions, leaving the vertex, turned
// round. Every half-edge starts at one vertex and has one face on its left, so each plane is kept once.
//
// Per edge four planes, as in `aos` (128 bytes in double, 64 in single), and a record of its own: ends,
// direction and length, and the places of its planes (64 bytes, 48 in single), 16 bytes more than `aos`. The
// price: a plane asked for by its edge, as tests of a single edge do, costs one more read and another line.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "edgewise/layout_parts/edge_records.hpp"
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

template <Precision P, class Loader = Direct>
class ring : public EdgeRecords<P, Loader, RingRecord<typename P::Stored>> {
    using Base = EdgeRecords<P, Loader, RingRecord<typename P::Stored>>;
    using Base::block_;
    using Base::edges_;
    using Base::load;
    using Base::rings_;

  public:
    using typename Base::Compute;
    using typename Base::Edge;
    using typename Base::Face;
    using typename Base::Stored;
    using typename Base::Vertex;

    static constexpr std::string_view name = "ring";
    static constexpr std::string_view stores =
        "Voronoi planes in ring order; one struct an edge: ends, places of its planes, direction, length";
    static constexpr std::string_view derives = "nothing";

    ring(const Polyhedron& body, Parts parts, Loader loader = {}, WriteEdges write = WriteEdges::now)
        : Base(loader) {
        const std::size_t count = Base::edges_of(body, parts);
        Slot<Plane<Stored>> vertex_edge{}, edge_face{};
        Slot<Record> edges{};
        this->build(body, parts, [&](BlockPlan& plan) {
            const Shares plane = {{Component::voronoi_planes, sizeof(Plane<Stored>)}};
            vertex_edge = plan.array<Plane<Stored>>(2 * count, plane);
            edge_face = plan.array<Plane<Stored>>(2 * count, plane);
            edges = plan.array<Record>(count, {{Component::topology, 8 * sizeof(Index)},
                                               {Component::edge_geometry, 4 * sizeof(Stored)}});
        });
        vertex_edge_ = block_.start(vertex_edge);
        edge_face_ = block_.start(edge_face);
        this->start_edges(edges, body);
        if (count > 0) place_planes(body);
        write_geometry(*this, body, write);
    }

    /// The same memory seen through another loader.
    template <class OtherLoader>
    ring(const ring<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), vertex_edge_(other.vertex_edge_), edge_face_(other.edge_face_) {}

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        const Index at = load(edges_[e].vertex_edge_at[static_cast<int>(end)], Field::vertex_ring);
        return cast<Compute>(load(vertex_edge_[at], Field::voronoi_plane));
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        const Index at = load(edges_[e].edge_face_at[static_cast<int>(side)], Field::face_ring);
        return cast<Compute>(load(edge_face_[at], Field::voronoi_plane));
    }

    /// See table/ring_questions.hpp.
    [[nodiscard]] std::optional<Edge> most_violated_vertex_plane(Vertex v, const Vec3<Compute>& point) const {
        return most_violated(vertex_edge_, rings_.vertex_ring, rings_.vertex_offset + v, Field::vertex_ring,
                             point);
    }
    [[nodiscard]] std::optional<Edge> most_violated_face_side(Face f, const Vec3<Compute>& point) const {
        return most_violated(edge_face_, rings_.face_ring, rings_.face_offset + f, Field::face_ring, point);
    }
    [[nodiscard]] auto steepest_descent(Vertex v, const Vec3<Compute>& normal) const {
        const Index first = load(rings_.vertex_offset[v], Field::vertex_ring);
        const Index last = load(rings_.vertex_offset[v + 1], Field::vertex_ring);
        Descent<ring> result;
        Index worst = last;
        for (Index at = first; at < last; ++at) {
            const auto backwards = cast<Compute>(load(vertex_edge_[at].normal, Field::voronoi_plane));
            const Compute slope = -dot(backwards, normal);
            result.steepest = std::max(result.steepest, std::abs(slope));
            worst = slope < result.slope ? at : worst;
            result.slope = std::min(result.slope, slope);
        }
        if (worst != last) result.edge = load(rings_.vertex_ring[worst], Field::vertex_ring) >> 1;
        return result;
    }

    void write_edge(Index e, const EdgeGeometry& g) {
        Record& edge = edges_[e];
        vertex_edge_[edge.vertex_edge_at[0]] = cast<Stored>(g.tail_plane);
        vertex_edge_[edge.vertex_edge_at[1]] = cast<Stored>(g.head_plane);
        edge_face_[edge.edge_face_at[0]] = cast<Stored>(g.left_plane);
        edge_face_[edge.edge_face_at[1]] = cast<Stored>(g.right_plane);
        edge.direction = cast<Stored>(g.direction);
        edge.length = static_cast<Stored>(g.length);
    }

  private:
    template <Precision, class>
    friend class ring;

    using Record = RingRecord<Stored>;

    /// Half-edges as edge-face planes are stored: ring after ring, and last those that have no face.
    static std::vector<HalfEdge> half_edges_by_face(const Polyhedron& body) {
        std::vector<HalfEdge> order = body.face_ring;
        for (HalfEdge h = 0; h < 2 * body.edge_count(); ++h) {
            if (body.face(h) == edgewise::no_face) order.push_back(h);
        }
        return order;
    }
    static std::vector<Index> places_in(const std::vector<HalfEdge>& order) {
        std::vector<Index> place(order.size());
        for (Index at = 0; at < order.size(); ++at) place[order[at]] = at;
        return place;
    }

    void place_planes(const Polyhedron& body) {
        const auto at_vertex = places_in(body.vertex_ring), at_face = places_in(half_edges_by_face(body));
        for (Index e = 0; e < body.edge_count(); ++e) {
            for (const Index k : {0U, 1U}) {
                edges_[e].vertex_edge_at[k] = at_vertex[2 * e + k];
                edges_[e].edge_face_at[k] = at_face[2 * e + k];
            }
        }
    }

    /// Selects instead of jumps, so that nothing holds up the distances of the planes that follow. Not in
    /// vectors: the n x, n y, n z and n offsets of a ring in rows, four planes a vector operation, took 1.09
    /// (double; 1.00 single) of the time of `aos` where this takes 0.94 (0.91; V-Clip, `cold`, 386 vertices).
    /// Rings of three and six planes fill vectors badly, and the search for the least is as long.
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

    Plane<Stored>* vertex_edge_ = nullptr;  // ring after ring, as in rings_.vertex_ring
    Plane<Stored>* edge_face_ = nullptr;    // ring after ring, as in rings_.face_ring
};

}  // namespace edgewise
