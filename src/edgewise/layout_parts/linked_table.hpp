// SPDX-License-Identifier: MIT
//
// A table of nodes and pointers: its answers, independent of the places of the nodes' fields. Handles are
// pointers to nodes.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/layout_parts/linked_body.hpp"
#include "edgewise/layout_parts/linked_builder.hpp"
#include "edgewise/layout_parts/linked_writer.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise {

/// NodePlaces: as for LinkedBody.
template <class NodePlaces, Precision P, class Loader>
class LinkedTable {
    using Nodes = typename NodePlaces::Nodes;
    using Spoke = typename Nodes::Spoke;
    using VertexCone = typename Nodes::VertexCone;
    using FaceCone = typename Nodes::FaceCone;
    using F = NodeField;

  public:
    using PrecisionType = P;
    using Stored = typename P::Stored;
    using Compute = typename P::Compute;
    using Vertex = const typename Nodes::Vertex*;
    using Edge = const typename Nodes::Edge*;
    using Face = const typename Nodes::Face*;

    static constexpr Face no_face = nullptr;
    static constexpr std::string_view derives = "nothing";

    LinkedTable(const Polyhedron& body, Parts parts, Loader loader = {})
        : loader_(loader), facts_(body, parts, Tolerance<Stored>::strict_turn), nodes_(facts_) {
        LinkedBuilder<NodePlaces>(body, parts == Parts::features, nodes_);
        write_body(body);
    }

    /// A view of the same memory with another loader; it must not outlive the table.
    template <class OtherLoader>
    LinkedTable(const LinkedTable<NodePlaces, P, OtherLoader>& other, Loader loader)
        : loader_(loader), facts_(other.facts_), nodes_(other.nodes_.view()) {}

    [[nodiscard]] std::size_t vertex_count() const { return facts_.vertex_count; }
    [[nodiscard]] Vertex first_vertex() const { return nodes_.first_vertex; }
    [[nodiscard]] Index index_of(Vertex v) const { return load<F::index>(v, Field::vertex); }
    [[nodiscard]] bool strictly_convex() const { return facts_.strictly_convex; }
    [[nodiscard]] bool climbable() const { return facts_.climbable; }
    [[nodiscard]] double reach() const { return facts_.reach; }
    [[nodiscard]] std::uint32_t identity() const { return facts_.identity; }
    [[nodiscard]] Ledger ledger() const { return ledger_of(pieces()); }
    [[nodiscard]] std::vector<Piece> pieces() const { return nodes_.pieces(); }
    /// Map of the fields by offset from `base`.
    [[nodiscard]] FieldMap field_map(const std::byte* base) const { return nodes_.field_map(base); }

    [[nodiscard]] auto all_vertices() const {
        return list<F::next_vertex>(Vertex{nodes_.first_vertex}, Field::vertex, [](Vertex v) { return v; });
    }
    [[nodiscard]] auto all_faces() const {
        return list<F::next_face>(Face{nodes_.first_face}, Field::face_plane, [](Face f) { return f; });
    }
    [[nodiscard]] auto neighbours(Vertex v) const {
        const Spoke* const first = load<F::spokes>(v, Field::neighbour);
        return list<F::next_spoke>(first, Field::neighbour, [this](const Spoke* s) {
            return load<F::neighbour>(s, Field::neighbour);
        });
    }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const {
        assert(facts_.parts == Parts::features);
        const auto* const first = static_cast<const VertexCone*>(load<F::spokes>(v, Field::vertex_ring));
        return list<F::next_spoke>(first, Field::vertex_ring, [this, v](const VertexCone* c) {
            const Edge e = load<F::vertex_edge>(c, Field::vertex_ring);
            return RingEdge<Edge>{e, head(e) == v};
        });
    }
    [[nodiscard]] auto ring_of_face(Face f) const {
        assert(f != no_face);
        const FaceCone* const first = load<F::cone>(f, Field::face_ring);
        return list<F::next_side>(first, Field::face_ring, [this, f](const FaceCone* c) {
            const Edge e = load<F::side_edge>(c, Field::face_ring);
            return RingEdge<Edge>{e, right(e) == f};
        });
    }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(load<F::point>(v, Field::vertex));
    }
    [[nodiscard]] Vertex tail(Edge e) const { return load<F::tail>(e, Field::edge_ends); }
    [[nodiscard]] Vertex head(Edge e) const { return load<F::head>(e, Field::edge_ends); }
    [[nodiscard]] Face left(Edge e) const { return load<F::left>(e, Field::edge_ends); }
    [[nodiscard]] Face right(Edge e) const { return load<F::right>(e, Field::edge_ends); }
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        return cast<Compute>(load<F::direction>(e, Field::edge_direction));
    }

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        const VertexCone* const c = end == End::tail ? load<F::tail_cone>(e, Field::edge_ends)
                                                     : load<F::head_cone>(e, Field::edge_ends);
        return cast<Compute>(load<F::vertex_plane>(c, Field::voronoi_plane));
    }
    /// Edge-face plane; negative everywhere on a side without a face.
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        const FaceCone* const c = side == Side::left ? load<F::left_cone>(e, Field::edge_ends)
                                                     : load<F::right_cone>(e, Field::edge_ends);
        if (!c) return {Vec3<Compute>::Zero(), -1};
        return cast<Compute>(load<F::side_plane>(c, Field::voronoi_plane));
    }
    [[nodiscard]] Plane<Compute> face_plane(Face f) const {
        assert(f != no_face);
        return cast<Compute>(load<F::face_plane>(f, Field::face_plane));
    }

    /// Takes over facts and numbers of a body of the same topology (write_geometry.hpp).
    void note_facts(const Polyhedron& body) {
        facts_ = facts_.refitted(body, Tolerance<Stored>::strict_turn);
    }
    void write_body(const Polyhedron& body) { LinkedWriter<NodePlaces>(nodes_, facts_.parts).write(body); }

  private:
    template <class, Precision, class>
    friend class LinkedTable;

    template <NodeField field, class Node>
    [[nodiscard]] const auto& load(const Node* node, Field name) const {
        return loader_.load(nodes_.template at<field>(loader_, node, name), name);
    }

    /// List from this node on; `item` turns a node into its value.
    template <NodeField next, class Node, class Item>
    [[nodiscard]] auto list(const Node* first, Field name, Item item) const {
        return Chain(first, static_cast<const Node*>(nullptr), item, [this, name](const Node* node) {
            return static_cast<const Node*>(load<next>(node, name));
        });
    }

    [[no_unique_address]] Loader loader_;
    BodyFacts facts_;
    LinkedBody<NodePlaces> nodes_;
};

}  // namespace edgewise
