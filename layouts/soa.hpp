// SPDX-License-Identifier: MIT
//
// Structure of arrays: the same scalars as `aos`, each in an array of its own: twenty for an edge, three for
// a vertex, four for a face. Made for passes over all edges; V-Clip jumps from edge to edge, and pays a cache
// line a scalar. More parallel arrays than a cache has ways is a trap of its own.
#pragma once

#include <array>
#include <cstddef>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/rings.hpp"
#include "edgewise/table/voronoi.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class soa {
  public:
    using PrecisionType = P;
    using Stored = typename P::Stored;
    using Compute = typename P::Compute;
    using Vertex = Index;
    using Edge = Index;
    using Face = Index;

    static constexpr Face no_face = edgewise::no_face;
    static constexpr std::string_view name = "soa";
    static constexpr std::string_view stores = "the scalars of aos, each in an array of its own";
    static constexpr std::string_view derives = "nothing";

    soa(const Polyhedron& body, Parts parts, Loader loader = {}) : loader_(loader) {
        const std::size_t edges = parts == Parts::features ? body.edge_count() : 0;
        const std::size_t faces = parts == Parts::features ? body.face_count() : 0;
        BlockPlan plan;
        const auto vertex_slots = plan_arrays<3>(plan, body.vertex_count(), Component::vertex_coordinates);
        const auto voronoi_slots = plan_arrays<16>(plan, edges, Component::voronoi_planes);
        const auto geometry_slots = plan_arrays<4>(plan, edges, Component::edge_geometry);
        const auto face_slots = plan_arrays<4>(plan, faces, Component::face_planes);
        const auto end_slots = plan_arrays<4, Index>(plan, edges, Component::topology);
        const RingSlots ring_slots(plan, body, parts);

        block_ = Block(plan);
        facts_ = BodyFacts(body, parts, Tolerance<Stored>::strict_turn);
        vertices_ = fill(vertex_slots, [&](Index v) {
            return std::array{body.vertices[v].x(), body.vertices[v].y(), body.vertices[v].z()};
        });
        voronoi_ = fill(voronoi_slots, [&](Index e) { return voronoi_scalars(edge_geometry(body, e)); });
        geometry_ = fill(geometry_slots, [&](Index e) {
            const EdgeGeometry g = edge_geometry(body, e);
            return std::array{g.direction.x(), g.direction.y(), g.direction.z(), g.length};
        });
        faces_ = fill(face_slots, [&](Index f) { return plane_scalars(body.face_planes[f]); });
        ends_ = fill(end_slots, [&](Index e) {
            const PolyhedronEdge& edge = body.edges[e];
            return std::array{edge.tail, edge.head, edge.left, edge.right};
        });
        rings_ = Rings(block_, ring_slots, body);
    }

    /// The same memory seen through another loader.
    template <class OtherLoader>
    soa(const soa<P, OtherLoader>& other, Loader loader)
        : loader_(loader),
          block_(other.block_),
          facts_(other.facts_),
          vertices_(other.vertices_),
          voronoi_(other.voronoi_),
          geometry_(other.geometry_),
          faces_(other.faces_),
          ends_(other.ends_),
          rings_(other.rings_) {}

    [[nodiscard]] std::size_t vertex_count() const { return facts_.vertex_count; }
    [[nodiscard]] Vertex first_vertex() const { return 0; }
    [[nodiscard]] Index index_of(Vertex v) const { return v; }
    [[nodiscard]] auto all_vertices() const { return index_range(facts_.vertex_count); }
    [[nodiscard]] auto all_faces() const { return index_range(facts_.face_count); }
    [[nodiscard]] bool strictly_convex() const { return facts_.strictly_convex; }
    [[nodiscard]] double reach() const { return facts_.reach; }
    [[nodiscard]] const Ledger& ledger() const { return block_.ledger(); }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const { return vector(&vertices_[0], v, Field::vertex); }
    [[nodiscard]] auto neighbours(Vertex v) const { return rings_.neighbours(loader_, v); }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const { return rings_.ring_of_vertex(loader_, v); }
    [[nodiscard]] auto ring_of_face(Face f) const { return rings_.ring_of_face(loader_, f); }

    [[nodiscard]] Vertex tail(Edge e) const { return loader_.load(ends_[0][e], Field::edge_ends); }
    [[nodiscard]] Vertex head(Edge e) const { return loader_.load(ends_[1][e], Field::edge_ends); }
    [[nodiscard]] Face left(Edge e) const { return loader_.load(ends_[2][e], Field::edge_ends); }
    [[nodiscard]] Face right(Edge e) const { return loader_.load(ends_[3][e], Field::edge_ends); }
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        return vector(&geometry_[0], e, Field::edge_direction);
    }

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        return plane(&voronoi_[4 * static_cast<std::size_t>(end)], e, Field::voronoi_plane);
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        return plane(&voronoi_[8 + 4 * static_cast<std::size_t>(side)], e, Field::voronoi_plane);
    }
    [[nodiscard]] Plane<Compute> face_plane(Face f) const { return plane(&faces_[0], f, Field::face_plane); }

  private:
    template <Precision, class>
    friend class soa;

    template <std::size_t Count, class Element = Stored>
    static std::array<Slot<Element>, Count> plan_arrays(BlockPlan& plan, std::size_t length, Component use) {
        std::array<Slot<Element>, Count> slots;
        for (auto& slot : slots) slot = plan.array<Element>(length, {{use, sizeof(Element)}});
        return slots;
    }

    /// Array k holds scalar k of make(i) at position i.
    template <class Element, std::size_t Count, class Make>
    std::array<const Element*, Count> fill(const std::array<Slot<Element>, Count>& slots, Make make) const {
        std::array<const Element*, Count> arrays;
        for (std::size_t k = 0; k < Count; ++k) {
            arrays[k] = block_.fill(slots[k], [&](Index i) { return static_cast<Element>(make(i)[k]); });
        }
        return arrays;
    }

    static std::array<double, 4> plane_scalars(const Plane<double>& p) {
        return {p.normal.x(), p.normal.y(), p.normal.z(), p.offset};
    }
    static std::array<double, 16> voronoi_scalars(const EdgeGeometry& g) {
        std::array<double, 16> result;
        double* to = result.data();
        for (const auto* p : {&g.tail_plane, &g.head_plane, &g.left_plane, &g.right_plane}) {
            for (const double scalar : plane_scalars(*p)) *to++ = scalar;
        }
        return result;
    }

    Vec3<Compute> vector(const Stored* const* arrays, Index i, Field field) const {
        const auto read = [&](int k) { return static_cast<Compute>(loader_.load(arrays[k][i], field)); };
        return {read(0), read(1), read(2)};
    }
    Plane<Compute> plane(const Stored* const* arrays, Index i, Field field) const {
        return {vector(arrays, i, field), static_cast<Compute>(loader_.load(arrays[3][i], field))};
    }

    [[no_unique_address]] Loader loader_;
    Block block_;
    BodyFacts facts_;
    std::array<const Stored*, 3> vertices_{};
    std::array<const Stored*, 16> voronoi_{};  // tail, head, left, right plane: normal and offset each
    std::array<const Stored*, 4> geometry_{};  // direction, length
    std::array<const Stored*, 4> faces_{};     // normal and offset
    std::array<const Index*, 4> ends_{};       // tail, head, left, right
    Rings rings_;
};

}  // namespace edgewise
