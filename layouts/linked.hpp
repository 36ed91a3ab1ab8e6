// SPDX-License-Identifier: MIT
//
// Nodes and pointers, as a program of 1998 would have held a body: a node per vertex, edge and face, and at
// each vertex and each face a linked list of the planes that bound its Voronoi region, its cone. Vertex and
// face tests walk a cone and never touch an edge unless they go there; an edge reaches its own four planes
// through its cones' nodes, one hop farther than an array would need. Handles are pointers to nodes.
//
// Each node is allocated by itself, in the order in which a builder would: each vertex and its cone, then the
// edges, then each face and its cone. The allocator decides where they lie, and its headers and size classes
// come on top. A support table has only vertices and spokes. The bytes: planes are in the cones, once each;
// all pointers are topology, eight bytes each, and 18 of them per edge, in its node and its four cone nodes:
// 144 bytes in addition to 160 bytes of planes, direction and length in double, 80 in single.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/layout_parts/linked_builder.hpp"
#include "edgewise/layout_parts/linked_nodes.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class linked {
    using Nodes = LinkedNodes<typename P::Stored>;
    using Spoke = typename Nodes::Spoke;
    using VertexCone = typename Nodes::VertexCone;
    using FaceCone = typename Nodes::FaceCone;

  public:
    using PrecisionType = P;
    using Stored = typename P::Stored;
    using Compute = typename P::Compute;
    using Vertex = const typename Nodes::Vertex*;
    using Edge = const typename Nodes::Edge*;
    using Face = const typename Nodes::Face*;

    static constexpr Face no_face = nullptr;
    static constexpr std::string_view name = "linked";
    static constexpr std::string_view stores =
        "nodes and pointers, planes in linked lists by vertex and face";
    static constexpr std::string_view derives = "nothing";

    linked(const Polyhedron& body, Parts parts, Loader loader = {})
        : loader_(loader), facts_(body, parts, Tolerance<Stored>::strict_turn), nodes_(parts) {
        LinkedBuilder<Stored>(body, parts == Parts::features, nodes_);
        write_body(body);
    }

    /// A view of the same memory with another loader; it must not outlive the table.
    template <class OtherLoader>
    linked(const linked<P, OtherLoader>& other, Loader loader)
        : loader_(loader), facts_(other.facts_), nodes_(other.nodes_.view()) {}

    [[nodiscard]] std::size_t vertex_count() const { return facts_.vertex_count; }
    [[nodiscard]] Vertex first_vertex() const { return nodes_.first_vertex; }
    [[nodiscard]] Index index_of(Vertex v) const { return load(v->index, Field::vertex); }
    [[nodiscard]] bool strictly_convex() const { return facts_.strictly_convex; }
    [[nodiscard]] bool climbable() const { return facts_.climbable; }
    [[nodiscard]] double reach() const { return facts_.reach; }
    [[nodiscard]] std::uint32_t identity() const { return facts_.identity; }
    [[nodiscard]] Ledger ledger() const { return ledger_of(pieces()); }
    [[nodiscard]] std::vector<Piece> pieces() const { return nodes_.pieces(); }

    [[nodiscard]] auto all_vertices() const {
        return list(Vertex{nodes_.first_vertex}, Field::vertex, [](Vertex v) { return v; });
    }
    [[nodiscard]] auto all_faces() const {
        return list(Face{nodes_.first_face}, Field::face_plane, [](Face f) { return f; });
    }
    [[nodiscard]] auto neighbours(Vertex v) const {
        const Spoke* const first = load(v->spokes, Field::neighbour);
        return list(first, Field::neighbour,
                    [this](const Spoke* s) { return Vertex{load(s->neighbour, Field::neighbour)}; });
    }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const {
        assert(facts_.parts == Parts::features);
        const auto* const first = static_cast<const VertexCone*>(load(v->spokes, Field::vertex_ring));
        return list(first, Field::vertex_ring, [this, v](const VertexCone* c) {
            const Edge e = load(c->edge, Field::vertex_ring);
            return RingEdge<Edge>{e, head(e) == v};
        });
    }
    [[nodiscard]] auto ring_of_face(Face f) const {
        assert(f != no_face);
        const FaceCone* const first = load(f->cone, Field::face_ring);
        return list(first, Field::face_ring, [this, f](const FaceCone* c) {
            const Edge e = load(c->edge, Field::face_ring);
            return RingEdge<Edge>{e, right(e) == f};
        });
    }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(load(v->point, Field::vertex));
    }
    [[nodiscard]] Vertex tail(Edge e) const { return load(e->tail, Field::edge_ends); }
    [[nodiscard]] Vertex head(Edge e) const { return load(e->head, Field::edge_ends); }
    [[nodiscard]] Face left(Edge e) const { return load(e->left, Field::edge_ends); }
    [[nodiscard]] Face right(Edge e) const { return load(e->right, Field::edge_ends); }
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        return cast<Compute>(load(e->direction, Field::edge_direction));
    }

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        const VertexCone* const c = load(end == End::tail ? e->tail_cone : e->head_cone, Field::edge_ends);
        return cast<Compute>(load(c->plane, Field::voronoi_plane));
    }
    /// Edge-face plane; negative everywhere on a side without a face.
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        const FaceCone* const c = load(side == Side::left ? e->left_cone : e->right_cone, Field::edge_ends);
        if (!c) return {Vec3<Compute>::Zero(), -1};
        return cast<Compute>(load(c->plane, Field::voronoi_plane));
    }
    [[nodiscard]] Plane<Compute> face_plane(Face f) const {
        assert(f != no_face);
        return cast<Compute>(load(f->plane, Field::face_plane));
    }

    /// Takes over facts and numbers of a body of the same topology (write_geometry.hpp).
    void note_facts(const Polyhedron& body) {
        facts_ = facts_.refitted(body, Tolerance<Stored>::strict_turn);
    }
    void write_body(const Polyhedron& body) { write_numbers(nodes_, facts_.parts, body); }

  private:
    template <Precision, class>
    friend class linked;

    template <class Value>
    const Value& load(const Value& location, Field field) const {
        return loader_.load(location, field);
    }

    /// List from this node on; `item` turns a node into its value.
    template <class Node, class Item>
    [[nodiscard]] auto list(const Node* first, Field field, Item item) const {
        return Chain(first, static_cast<const Node*>(nullptr), item, [this, field](const Node* node) {
            return static_cast<const Node*>(load(node->next, field));
        });
    }

    [[no_unique_address]] Loader loader_;
    BodyFacts facts_;
    LinkedBody<Stored> nodes_;
};

}  // namespace edgewise
