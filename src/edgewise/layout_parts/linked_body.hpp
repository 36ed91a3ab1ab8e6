// SPDX-License-Identifier: MIT
//
// All nodes of the layout `linked`: each asked for by itself, as `new` would, and given back one by one.
// Nodes are found again by following their own pointers, so nothing is kept beside them.
#pragma once

#include <cassert>
#include <cstddef>
#include <memory_resource>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "edgewise/layout_parts/linked_nodes.hpp"
#include "edgewise/table/needs.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise {

/// Of one owner; views borrow the nodes and must not outlive it.
template <class Stored>
class LinkedBody {
    using Nodes = LinkedNodes<Stored>;
    using Vertex = typename Nodes::Vertex;
    using Face = typename Nodes::Face;
    using Spoke = typename Nodes::Spoke;
    using VertexCone = typename Nodes::VertexCone;

  public:
    /// Nothing yet. With features, spokes are vertex cones.
    explicit LinkedBody(Parts parts) : parts_(parts), owner_(&table_memory()) {}
    ~LinkedBody() {
        if (!owner_) return;
        if (parts_ == Parts::features) leave_edges_to_their_tails();
        for_each_node(
            [this](auto* node) { owner_->deallocate(node, sizeof(*node), alignof(decltype(*node))); });
    }
    LinkedBody(LinkedBody&& other) noexcept
        : first_vertex(other.first_vertex),
          first_face(other.first_face),
          parts_(other.parts_),
          owner_(std::exchange(other.owner_, nullptr)) {}
    LinkedBody& operator=(LinkedBody&& other) noexcept {
        std::swap(first_vertex, other.first_vertex);
        std::swap(first_face, other.first_face);
        std::swap(parts_, other.parts_);
        std::swap(owner_, other.owner_);
        return *this;
    }

    /// The same nodes, borrowed.
    [[nodiscard]] LinkedBody view() const {
        LinkedBody borrowed(parts_);
        borrowed.owner_ = nullptr;
        borrowed.first_vertex = first_vertex;
        borrowed.first_face = first_face;
        return borrowed;
    }

    /// A new node, its pointers null; whoever asks ties it to what is there before asking for the next.
    template <class Node>
    [[nodiscard]] Node* make() const {
        static_assert(std::is_trivially_destructible_v<Node>);
        assert(owner_);
        return new (owner_->allocate(sizeof(Node), alignof(Node))) Node{};
    }

    [[nodiscard]] std::vector<Piece> pieces() const {
        std::vector<Piece> all;
        for_each_node([&](const auto* node) {
            all.push_back({reinterpret_cast<const std::byte*>(node), sizeof(*node), 1, node->shares()});
        });
        return all;
    }

    Vertex* first_vertex = nullptr;  ///< of a list in the body's order
    Face* first_face = nullptr;      ///< likewise

  private:
    /// A node may be given back while it is visited.
    template <class Visit>
    void for_each_node(Visit visit) const {
        for_each_in(first_vertex, [&](Vertex* vertex) {
            for_each_in(vertex->spokes, [&](Spoke* spoke) { visit_spoke(spoke, visit); });
            visit(vertex);
        });
        for_each_in(first_face, [&](Face* face) {
            for_each_in(face->cone, visit);
            visit(face);
        });
    }
    /// With the edge whose tail is here.
    template <class Visit>
    void visit_spoke(Spoke* spoke, Visit visit) const {
        if (parts_ == Parts::support) return visit(spoke);
        auto* const cone = static_cast<VertexCone*>(spoke);
        if (cone->edge && cone->edge->vertex_cone[0] == cone) visit(cone->edge);
        visit(cone);
    }
    template <class Node, class Visit>
    static void for_each_in(Node* node, Visit visit) {
        while (node) {
            Node* const next = static_cast<Node*>(node->next);
            visit(node);
            node = next;
        }
    }

    /// So that the cone at an edge's head does not look at an edge that was given back.
    void leave_edges_to_their_tails() const {
        for_each_in(first_vertex, [](Vertex* vertex) {
            for_each_in(vertex->spokes, [](Spoke* spoke) {
                auto* const cone = static_cast<VertexCone*>(spoke);
                if (cone->edge && cone->edge->vertex_cone[1] == cone) cone->edge = nullptr;
            });
        });
    }

    Parts parts_;
    std::pmr::memory_resource* owner_;  // none: borrowed
};

}  // namespace edgewise
