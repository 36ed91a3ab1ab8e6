// SPDX-License-Identifier: MIT
//
// All nodes of a table of nodes and pointers. Their own pointers lead to all of them, so no list of nodes is
// kept.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <type_traits>
#include <utility>
#include <vector>

#include "edgewise/layout_parts/linked_nodes.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/field_map.hpp"
#include "edgewise/table/loader.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise {

/// The nodes of one owner; views borrow them and must not outlive it. NodePlaces: places of the fields in
/// nodes, as in NodeStructs.
template <class NodePlaces>
class LinkedBody {
    using Nodes = typename NodePlaces::Nodes;
    using Vertex = typename Nodes::Vertex;
    using Edge = typename Nodes::Edge;
    using Face = typename Nodes::Face;
    using Spoke = typename Nodes::Spoke;
    using VertexCone = typename Nodes::VertexCone;
    using FaceCone = typename Nodes::FaceCone;

  public:
    /// Has no nodes yet. With features, spokes are vertex cones.
    explicit LinkedBody(const BodyFacts& facts) : parts_(facts.parts), owner_(&table_memory()) {
        places_.prepare(facts, *owner_);
    }
    ~LinkedBody() {
        if (!owner_) return;
        if (parts_ == Parts::features) leave_edges_to_their_tails();
        for_each_node([this](auto* node) { places_.give_back(node, *owner_); });
        places_.release(*owner_);
    }
    LinkedBody(LinkedBody&& other) noexcept
        : first_vertex(other.first_vertex),
          first_face(other.first_face),
          parts_(other.parts_),
          owner_(std::exchange(other.owner_, nullptr)),
          places_(other.places_) {}
    LinkedBody& operator=(LinkedBody&& other) noexcept {
        std::swap(first_vertex, other.first_vertex);
        std::swap(first_face, other.first_face);
        std::swap(parts_, other.parts_);
        std::swap(owner_, other.owner_);
        std::swap(places_, other.places_);
        return *this;
    }

    /// Returns a view that borrows the same nodes.
    [[nodiscard]] LinkedBody view() const {
        LinkedBody borrowed;
        borrowed.parts_ = parts_;
        borrowed.first_vertex = first_vertex;
        borrowed.first_face = first_face;
        borrowed.places_ = places_;
        return borrowed;
    }

    /// A new node with null pointers; the caller links it before asking for the next one.
    template <class Node>
    [[nodiscard]] Node* make() {
        assert(owner_);
        return places_.template make<Node>(*owner_);
    }

    /// The place of a node's field. If a pointer leads there, the loader reads it under this name.
    template <NodeField field, class Loader, class Node>
    [[nodiscard]] auto& at(const Loader& loader, Node* node, Field name) const {
        return places_.template at<field>(loader, node, name);
    }
    /// The place of a node's field for building and writing, without a loader.
    template <NodeField field, class Node>
    [[nodiscard]] auto& at(Node* node) const {
        return at<field>(Direct(), node, Field::edge_ends);
    }

    [[nodiscard]] std::vector<Piece> pieces() const {
        std::vector<Piece> all;
        for_each_node([&](const auto* node) { places_.add_piece(node, all); });
        places_.add_further_pieces(all);
        return all;
    }

    /// Map of the fields; numbers nodes by kind, in the order of the visit.
    [[nodiscard]] FieldMap field_map(const std::byte* base) const {
        const auto sized = sized_node_fields<typename NodePlaces::Stored>();
        FieldMap map{{sized.begin(), sized.end()}, {}};
        std::uint32_t visited[node_kind_count] = {};
        for_each_node([&]<class Node>(Node* node) {
            constexpr NodeKind kind = kind_of<typename NodePlaces::Stored, Node>();
            const std::uint32_t element = visited[static_cast<std::size_t>(kind)]++;
            for_each_node_field([&](auto field) {
                if constexpr (holds<Node, field()>()) {
                    const auto* const at = reinterpret_cast<const std::byte*>(&this->at<field()>(node));
                    map.places.push_back(
                        {static_cast<std::uint64_t>(at - base), element, static_cast<std::uint8_t>(field()),
                         0, static_cast<std::uint8_t>(sized[static_cast<std::size_t>(field())].bytes)});
                }
            });
        });
        return map;
    }

    Vertex* first_vertex = nullptr;  ///< start of a list in the body's order
    Face* first_face = nullptr;      ///< start of a list in the body's order

  private:
    LinkedBody() = default;

    template <class Node, NodeField field>
    [[nodiscard]] static constexpr bool holds() {
        constexpr bool of_kind = info_of(field).kind == kind_of<typename NodePlaces::Stored, Node>();
        constexpr bool of_cone = field == NodeField::vertex_plane || field == NodeField::vertex_edge;
        return of_kind && !(of_cone && std::is_same_v<Node, Spoke>);
    }

    /// Visits all nodes; `visit` may give a node back.
    template <class Visit>
    void for_each_node(Visit visit) const {
        for_each_in<NodeField::next_vertex>(first_vertex, [&](Vertex* vertex) {
            for_each_in<NodeField::next_spoke>(at<NodeField::spokes>(vertex),
                                               [&](Spoke* spoke) { visit_spoke(spoke, visit); });
            visit(vertex);
        });
        for_each_in<NodeField::next_face>(first_face, [&](Face* face) {
            for_each_in<NodeField::next_side>(at<NodeField::cone>(face), visit);
            visit(face);
        });
    }
    /// Visits a spoke, and the edge if its tail is here.
    template <class Visit>
    void visit_spoke(Spoke* spoke, Visit visit) const {
        if (parts_ == Parts::support) return visit(spoke);
        auto* const cone = static_cast<VertexCone*>(spoke);
        Edge* const edge = at<NodeField::vertex_edge>(cone);
        if (edge && at<NodeField::tail_cone>(edge) == cone) visit(edge);
        visit(cone);
    }
    template <NodeField next_field, class Node, class Visit>
    void for_each_in(Node* node, Visit visit) const {
        while (node) {
            Node* const next = at<next_field>(node);
            visit(node);
            node = next;
        }
    }

    /// Clears the edges of cones at heads, so that no cone refers to an edge that was given back.
    void leave_edges_to_their_tails() const {
        for_each_in<NodeField::next_vertex>(first_vertex, [this](Vertex* vertex) {
            for_each_in<NodeField::next_spoke>(at<NodeField::spokes>(vertex), [this](Spoke* spoke) {
                auto* const cone = static_cast<VertexCone*>(spoke);
                Edge*& edge = at<NodeField::vertex_edge>(cone);
                if (edge && at<NodeField::head_cone>(edge) == cone) edge = nullptr;
            });
        });
    }

    Parts parts_ = Parts::support;
    std::pmr::memory_resource* owner_ = nullptr;  // none: borrowed
    [[no_unique_address]] NodePlaces places_;
};

}  // namespace edgewise
