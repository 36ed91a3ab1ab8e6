// SPDX-License-Identifier: MIT
//
// The half-edges of SWIFT, a library for proximity by Voronoi regions (SWIFT 1.1, its mesh.h): 104 bytes
// each. 64 of the bytes are two unit vectors with their offsets, here the planes at the half-edge's origin
// and next to its face; then the half-edges after and before it around the face, its twin, its origin and its
// face. A vertex is its coordinates and a half-edge, 32 bytes, a face its plane and a half-edge, 40. 245
// bytes per edge. Only the structure is the library's, from its published list of fields; the algorithms are
// ours.
//
// Departures: numbers replace SWIFT's pointers, in the same size. Its list names four of them after the 64
// bytes; we assume that the fifth is the half-edge before. The library's hierarchy of coarser bodies, 48
// bytes per edge of each level, and its look-up table of directions are left out (lean_seeds114 and
// lean_seeds482 have tables of that size). Planes are those of `aos` to the bit. Everything is always stored,
// also in a table for GJK (keeps_faces, table/contract.hpp).
#pragma once

#include <cassert>
#include <cstdint>
#include <string_view>
#include <vector>

#include "edgewise/layout_parts/half_edge_table.hpp"
#include "edgewise/layout_parts/voronoi.hpp"

namespace edgewise {

/// An index in the size of a pointer.
using SwiftLink = std::uint64_t;

template <class Stored>
struct SwiftHalfEdge {
    Plane<Stored> at_origin, beside_face;  ///< positive beyond the origin, and on the face's side
    SwiftLink next, before, twin, origin, face;
};

template <class Stored>
struct SwiftVertex {
    Vec3<Stored> point;
    SwiftLink half_edge;
};

template <class Stored>
struct SwiftFace {
    Plane<Stored> plane;
    SwiftLink half_edge;
};

/// The start of each array, in bytes from the block's start.
template <class Stored>
struct SwiftPlaces {
    using HalfEdgeRecord = SwiftHalfEdge<Stored>;
    using VertexRecord = SwiftVertex<Stored>;
    using FaceRecord = SwiftFace<Stored>;

    std::uint32_t vertices = 0, half_edges = 0, faces = 0;

    void place(BlockPlan& plan, const BodyFacts& n) {
        vertices = plan.array_at<VertexRecord>(n.vertex_count,
                                               {{Component::vertex_coordinates, sizeof(Vec3<Stored>)},
                                                {Component::topology, sizeof(SwiftLink)}});
        half_edges = plan.array_at<HalfEdgeRecord>(n.neighbour_count,
                                                   {{Component::voronoi_planes, 2 * sizeof(Plane<Stored>)},
                                                    {Component::topology, 5 * sizeof(SwiftLink)}});
        faces = plan.array_at<FaceRecord>(n.face_count, {{Component::face_planes, sizeof(Plane<Stored>)},
                                                         {Component::topology, sizeof(SwiftLink)}});
    }
};

template <Precision P, class Loader = Direct>
class swift : public HalfEdgeTable<swift<P, Loader>, SwiftPlaces<typename P::Stored>, P, Loader> {
    using Base = HalfEdgeTable<swift<P, Loader>, SwiftPlaces<typename P::Stored>, P, Loader>;
    using Base::facts_, Base::load, Base::places_;

  public:
    using typename Base::Compute, typename Base::Edge, typename Base::Face, typename Base::Stored,
        typename Base::Vertex;

    static constexpr std::string_view name = "swift";
    static constexpr std::string_view stores =
        "SWIFT's half-edges: two planes each, next, before, twin, origin, face; vertices and faces";
    static constexpr std::string_view derives = "nothing";
    static constexpr bool keeps_faces = true;

    /// Both kinds of parts are the same here: the library keeps everything.
    swift(const Polyhedron& body, Parts /*parts*/, Loader loader = {}) : Base(body, Parts::features, loader) {
        const std::vector<HalfEdge> successor = this->successors(body);
        for (HalfEdge h = 0; h < successor.size(); ++h) {
            half_edges()[h].next = successor[h];
            half_edges()[successor[h]].before = h;
            half_edges()[h].twin = h ^ 1;
            half_edges()[h].origin = body.tail(h);
            half_edges()[h].face = body.face(h);
        }
        for (Index v = 0; v < facts_.vertex_count; ++v)
            vertices()[v].half_edge = body.edge_count() > 0 ? body.ring_of_vertex(v)[0] : 0;
        for (Index f = 0; f < facts_.face_count; ++f) faces()[f].half_edge = body.ring_of_face(f)[0];
        write_geometry(*this, body);
    }

    using Base::Base;

    void write_vertex(Index v, const Vec3d& point) { vertices()[v].point = cast<Stored>(point); }
    void write_edge(Index e, const EdgeGeometry& g) {
        auto &forth = half_edges()[2 * e], &back = half_edges()[2 * e + 1];
        forth.at_origin = cast<Stored>(g.tail_plane);
        forth.beside_face = cast<Stored>(g.left_plane);
        back.at_origin = cast<Stored>(g.head_plane);
        back.beside_face = cast<Stored>(g.right_plane);
    }
    void write_face(Index f, const Plane<double>& plane) { faces()[f].plane = cast<Stored>(plane); }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        return cast<Compute>(load(vertices()[v].point, Field::vertex));
    }
    /// Direction of the edge: the normal of its plane at the head.
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        assert(e < facts_.edge_count());
        return cast<Compute>(load(half_edges()[2 * e + 1].at_origin.normal, Field::edge_direction));
    }
    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        return cast<Compute>(load(half_edges()[2 * e + (end == End::head)].at_origin, Field::voronoi_plane));
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        return cast<Compute>(
            load(half_edges()[2 * e + (side == Side::right)].beside_face, Field::voronoi_plane));
    }
    [[nodiscard]] Plane<Compute> face_plane(Face f) const {
        assert(f < facts_.face_count);
        return cast<Compute>(load(faces()[f].plane, Field::face_plane));
    }

  private:
    friend Base;

    using Places = SwiftPlaces<Stored>;

    /// Steps between half-edges that HalfEdgeTable needs.
    [[nodiscard]] Index next(Index h) const { return link(half_edges()[h].next, Field::face_ring); }
    [[nodiscard]] Index before(Index h) const { return link(half_edges()[h].before, Field::vertex_ring); }
    [[nodiscard]] Index twin(Index h) const { return link(half_edges()[h].twin, Field::vertex_ring); }
    [[nodiscard]] Index origin(Index h) const { return link(half_edges()[h].origin, Field::edge_ends); }
    [[nodiscard]] Face face_of(Index h) const { return link(half_edges()[h].face, Field::edge_ends); }
    [[nodiscard]] Index leaving(Vertex v) const { return link(vertices()[v].half_edge, Field::vertex_ring); }
    [[nodiscard]] Index first_of(Face f) const { return link(faces()[f].half_edge, Field::face_ring); }

    [[nodiscard]] Index link(const SwiftLink& at, Field field) const {
        return static_cast<Index>(load(at, field));
    }
    [[nodiscard]] auto* vertices() const {
        return this->template array<typename Places::VertexRecord>(places_.vertices);
    }
    [[nodiscard]] auto* half_edges() const {
        return this->template array<typename Places::HalfEdgeRecord>(places_.half_edges);
    }
    [[nodiscard]] auto* faces() const {
        return this->template array<typename Places::FaceRecord>(places_.faces);
    }
};

}  // namespace edgewise
