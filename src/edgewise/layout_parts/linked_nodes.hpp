// SPDX-License-Identifier: MIT
//
// The nodes of the layout `linked`, and their owner. The nodes' own pointers lead to all of them, so no list
// of nodes is kept.
#pragma once

#include <cassert>
#include <cstddef>
#include <memory_resource>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/table/needs.hpp"
#include "edgewise/table/pieces.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise {

/// A spoke is one edge as seen from a vertex, and all that a support table knows of it; a vertex cone is a
/// spoke with the plane of its edge there, a face cone the corresponding node in the list of a face. Each
/// node's shares() are the purposes of its bytes, in memory order.
template <class Stored>
struct LinkedNodes {
    static constexpr std::size_t link = sizeof(void*);

    struct Spoke;
    struct VertexCone;
    struct FaceCone;

    struct Vertex {
        Vec3<Stored> point;
        Index index;  // index in the canonical body
        Spoke* spokes;
        Vertex* next;

        static Shares shares() {
            constexpr std::size_t fields = sizeof(Vec3<Stored>) + sizeof(Index) + 2 * link;
            return {{Component::vertex_coordinates, sizeof(Vec3<Stored>)},
                    {Component::topology, sizeof(Index)},
                    {Component::padding, sizeof(Vertex) - fields},
                    {Component::topology, 2 * link}};
        }
    };
    struct Face {
        Plane<Stored> plane;
        FaceCone* cone;
        Face* next;

        static Shares shares() {
            return {{Component::face_planes, sizeof(Plane<Stored>)}, {Component::topology, 2 * link}};
        }
    };
    struct Edge {
        Vec3<Stored> direction;
        Stored length;
        Vertex *tail, *head;
        Face *left, *right;
        VertexCone *tail_cone, *head_cone;
        FaceCone *left_cone, *right_cone;

        static Shares shares() {
            return {{Component::edge_geometry, 4 * sizeof(Stored)}, {Component::topology, 8 * link}};
        }
    };
    struct Spoke {
        Vertex* neighbour;
        Spoke* next;

        static Shares shares() { return {{Component::topology, 2 * link}}; }
    };
    struct VertexCone : Spoke {
        Plane<Stored> plane;
        Edge* edge;

        static Shares shares() {
            return {{Component::topology, 2 * link},
                    {Component::voronoi_planes, sizeof(Plane<Stored>)},
                    {Component::topology, link}};
        }
    };
    struct FaceCone {
        Plane<Stored> plane;
        Edge* edge;
        FaceCone* next;

        static Shares shares() {
            return {{Component::voronoi_planes, sizeof(Plane<Stored>)}, {Component::topology, 2 * link}};
        }
    };
};

/// The nodes of one owner; views borrow them and must not outlive it.
template <class Stored>
class LinkedBody {
    using Nodes = LinkedNodes<Stored>;
    using Vertex = typename Nodes::Vertex;
    using Edge = typename Nodes::Edge;
    using Face = typename Nodes::Face;
    using Spoke = typename Nodes::Spoke;
    using VertexCone = typename Nodes::VertexCone;

  public:
    /// Has no nodes yet. With features, spokes are vertex cones.
    explicit LinkedBody(Parts parts) : parts_(parts), owner_(&table_memory()) {}
    ~LinkedBody() {
        if (!owner_) return;
        if (parts_ == Parts::features) leave_edges_to_their_tails();
        for_each_node(
            [this]<class Node>(Node* node) { owner_->deallocate(node, sizeof(Node), alignof(Node)); });
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

    /// Returns a view that borrows the same nodes.
    [[nodiscard]] LinkedBody view() const {
        LinkedBody borrowed;
        borrowed.parts_ = parts_;
        borrowed.first_vertex = first_vertex;
        borrowed.first_face = first_face;
        return borrowed;
    }

    /// Makes a node with null pointers; the caller links it before asking for the next one.
    template <class Node>
    [[nodiscard]] Node* make() {
        static_assert(std::is_trivially_destructible_v<Node>);
        assert(owner_);
        return new (owner_->allocate(sizeof(Node), alignof(Node))) Node{};
    }

    [[nodiscard]] std::vector<Piece> pieces() const {
        std::vector<Piece> all;
        for_each_node([&]<class Node>(const Node* node) {
            all.push_back({reinterpret_cast<const std::byte*>(node), sizeof(Node), 1, Node::shares()});
        });
        return all;
    }

    Vertex* first_vertex = nullptr;  ///< start of a list in the body's order
    Face* first_face = nullptr;      ///< start of a list in the body's order

  private:
    LinkedBody() = default;

    /// Visits all nodes; `visit` may give a node back.
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
    /// Visits a spoke, and the edge if its tail is here.
    template <class Visit>
    void visit_spoke(Spoke* spoke, Visit visit) const {
        if (parts_ == Parts::support) return visit(spoke);
        auto* const cone = static_cast<VertexCone*>(spoke);
        if (cone->edge && cone->edge->tail_cone == cone) visit(cone->edge);
        visit(cone);
    }
    template <class Node, class Visit>
    static void for_each_in(Node* node, Visit visit) {
        while (node) {
            Node* const next = node->next;
            visit(node);
            node = next;
        }
    }

    /// Clears the edges of cones at heads, so that no cone refers to an edge that was given back.
    void leave_edges_to_their_tails() const {
        for_each_in(first_vertex, [](Vertex* vertex) {
            for_each_in(vertex->spokes, [](Spoke* spoke) {
                auto* const cone = static_cast<VertexCone*>(spoke);
                if (cone->edge && cone->edge->head_cone == cone) cone->edge = nullptr;
            });
        });
    }

    Parts parts_ = Parts::support;
    std::pmr::memory_resource* owner_ = nullptr;  // none: borrowed
};

}  // namespace edgewise
