// SPDX-License-Identifier: MIT
//
// The hull of Box3D (revision 30c67b5e, include/box3d/types.h): half-edges of four bytes (next, twin, origin,
// face), one half-edge for each vertex and each face, points, face planes, and points and normals once more
// in arrays of x, y and z, which its scans read four at a time. 35.7 bytes per edge. Only the structure is
// the engine's, from its published list of fields; the algorithms are ours.
//
// A scan over the arrays finds support points, as in the engine. V-Clip walks the half-edges. No half-edge
// knows the one before: a counter-clockwise step around a vertex goes around the face to the half-edge before
// and over to its twin. Planes of edges are derived, from points and face normals. Everything is always
// stored, also in a table for GJK (keeps_faces, table/contract.hpp). The engine accepts at most 128 edges,
// since eight bits number the half-edges; larger bodies are refused.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "edgewise/layout_parts/half_edge_table.hpp"
#include "edgewise/layout_parts/lane_scan.hpp"
#include "edgewise/layout_parts/voronoi.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

struct BoxHalfEdge {
    std::uint8_t next, twin, origin, face;
};

/// The start of each array, in bytes from the block's start, in the engine's order.
template <class Stored>
struct BoxPlaces {
    static constexpr std::size_t lanes = 4;
    using Axes = SmallArray<std::uint32_t, 3>;

    std::uint32_t vertices = 0, points = 0, edges = 0, planes = 0, faces = 0;
    Axes point_axes{}, normal_axes{};  ///< padded to full lanes

    void place(BlockPlan& plan, const BodyFacts& n) {
        const Shares byte = {{Component::topology, 1}};
        vertices = plan.array_at<std::uint8_t>(n.vertex_count, byte);
        points = plan.array_at<Vec3<Stored>>(n.vertex_count,
                                             {{Component::vertex_coordinates, sizeof(Vec3<Stored>)}});
        edges = plan.array_at<BoxHalfEdge>(n.neighbour_count, {{Component::topology, sizeof(BoxHalfEdge)}});
        planes =
            plan.array_at<Plane<Stored>>(n.face_count, {{Component::face_planes, sizeof(Plane<Stored>)}});
        faces = plan.array_at<std::uint8_t>(n.face_count, byte);
        place_axes(plan, n.vertex_count, Component::vertex_coordinates, point_axes);
        place_axes(plan, n.face_count, Component::face_planes, normal_axes);
    }

    [[nodiscard]] static std::size_t groups(std::size_t count) { return (count + lanes - 1) / lanes; }

  private:
    static void place_axes(BlockPlan& plan, std::size_t count, Component use, Axes& at) {
        for (std::uint32_t& start : at) {
            start = plan.array_at<Stored>(count, {{use, sizeof(Stored)}});
            plan.array_at<Stored>(groups(count) * lanes - count, {});
        }
    }
};

template <Precision P, class Loader = Direct>
class box3d : public HalfEdgeTable<box3d<P, Loader>, BoxPlaces<typename P::Stored>, P, Loader> {
    using Base = HalfEdgeTable<box3d<P, Loader>, BoxPlaces<typename P::Stored>, P, Loader>;
    using Base::facts_, Base::load, Base::places_;

  public:
    using typename Base::Compute, typename Base::Edge, typename Base::Face, typename Base::Stored,
        typename Base::Vertex;

    static constexpr std::string_view name = "box3d";
    static constexpr std::string_view stores =
        "Box3D's hull (30c67b5e): half-edges of four bytes, points and face planes, in lanes once more";
    static constexpr std::string_view derives = "planes of edges; support points, by scans";
    static constexpr bool keeps_faces = true;
    static constexpr std::size_t most_neighbours = 2 * 128;

    /// Both kinds of parts are the same here: the engine keeps everything.
    box3d(const Polyhedron& body, Parts /*parts*/, Loader loader = {}) : Base(body, Parts::features, loader) {
        assert(body.vertex_ring.size() <= most_neighbours && "stored_body refuses larger ones");
        const auto byte = [](Index i) { return static_cast<std::uint8_t>(i); };
        const std::vector<HalfEdge> successor = this->successors(body);
        for (HalfEdge h = 0; h < successor.size(); ++h)
            edges()[h] = {byte(successor[h]), byte(h ^ 1), byte(body.tail(h)), byte(body.face(h))};
        for (Index v = 0; v < facts_.vertex_count; ++v)
            vertices()[v] = body.edge_count() > 0 ? byte(body.ring_of_vertex(v)[0]) : 0;
        for (Index f = 0; f < facts_.face_count; ++f) faces()[f] = byte(body.ring_of_face(f)[0]);
        write_geometry(*this, body);
    }

    using Base::Base;

    void write_vertex(Index v, const Vec3d& point) {
        points()[v] = cast<Stored>(point);
        write_lanes(places_.point_axes, v, facts_.vertex_count, point);
    }
    void write_face(Index f, const Plane<double>& plane) {
        planes()[f] = cast<Stored>(plane);
        write_lanes(places_.normal_axes, f, facts_.face_count, plane.normal);
    }

    /// Always false: the engine scans.
    [[nodiscard]] static bool climbable() { return false; }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        return cast<Compute>(load(points()[v], Field::vertex));
    }
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        const Vec3<Compute> along = vertex(this->head(e)) - vertex(this->tail(e));
        return along / norm(along);
    }
    [[nodiscard]] AnchoredPlane<Compute> vertex_edge_plane(Edge e, End end) const {
        return plane_beyond(end, direction(e), vertex(end == End::tail ? this->tail(e) : this->head(e)));
    }
    [[nodiscard]] AnchoredPlane<Compute> edge_face_plane(Edge e, Side side) const {
        const Vec3<Compute> tail = vertex(this->tail(e));
        const Face face = side == Side::left ? this->left(e) : this->right(e);
        if (face == Base::no_face) return plane_beside_nothing(tail);
        return plane_beside(side, direction(e), face_plane(face).normal, tail);
    }
    [[nodiscard]] Plane<Compute> face_plane(Face f) const {
        assert(f < facts_.face_count);
        return cast<Compute>(load(planes()[f], Field::face_plane));
    }

    /// Returns the vertex farthest along the direction, the first of equals.
    [[nodiscard]] Vertex scan_support(const Vec3<Compute>& direction) const {
        const SmallArray<Stored*, 3> axes = {axis(places_.point_axes, 0), axis(places_.point_axes, 1),
                                             axis(places_.point_axes, 2)};
        return farthest_in_lanes<lanes>(
            Places::groups(facts_.vertex_count), direction, [&](int k, std::size_t group, std::size_t lane) {
                return static_cast<Compute>(load(axes[k][group * lanes + lane], Field::vertex));
            });
    }

  private:
    friend Base;

    using Places = BoxPlaces<Stored>;
    static constexpr std::size_t lanes = Places::lanes;

    /// Steps between half-edges that HalfEdgeTable needs.
    [[nodiscard]] Index next(Index h) const { return load(edges()[h].next, Field::face_ring); }
    [[nodiscard]] Index twin(Index h) const { return load(edges()[h].twin, Field::vertex_ring); }
    [[nodiscard]] Index origin(Index h) const { return load(edges()[h].origin, Field::edge_ends); }
    [[nodiscard]] Face face_of(Index h) const {
        const Index face = load(edges()[h].face, Field::edge_ends);
        return facts_.face_count == 0 ? Base::no_face : face;
    }
    [[nodiscard]] Index before(Index h) const {
        Index at = h;
        for (Index after = next(at); after != h; after = next(at)) at = after;
        return at;
    }
    [[nodiscard]] Index leaving(Vertex v) const { return load(vertices()[v], Field::vertex_ring); }
    [[nodiscard]] Index first_of(Face f) const { return load(faces()[f], Field::face_ring); }

    /// Writes an element's numbers; the last element also fills the free lanes behind it.
    void write_lanes(const typename Places::Axes& axes, Index i, Index count, const Vec3d& numbers) const {
        const std::size_t end = i + 1 == count ? Places::groups(count) * lanes : std::size_t{i} + 1;
        for (int k = 0; k < 3; ++k)
            std::fill(axis(axes, k) + i, axis(axes, k) + end, static_cast<Stored>(numbers[k]));
    }
    [[nodiscard]] Stored* axis(const typename Places::Axes& axes, int k) const {
        return this->template array<Stored>(axes[k]);
    }
    [[nodiscard]] std::uint8_t* vertices() const {
        return this->template array<std::uint8_t>(places_.vertices);
    }
    [[nodiscard]] Vec3<Stored>* points() const { return this->template array<Vec3<Stored>>(places_.points); }
    [[nodiscard]] BoxHalfEdge* edges() const { return this->template array<BoxHalfEdge>(places_.edges); }
    [[nodiscard]] Plane<Stored>* planes() const {
        return this->template array<Plane<Stored>>(places_.planes);
    }
    [[nodiscard]] std::uint8_t* faces() const { return this->template array<std::uint8_t>(places_.faces); }
};

}  // namespace edgewise
