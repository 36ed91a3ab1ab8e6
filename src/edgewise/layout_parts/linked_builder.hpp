// SPDX-License-Identifier: MIT
//
// Builds the nodes of the layout `linked`, one by one, and ties them together.
#pragma once

#include <vector>

#include "edgewise/layout_parts/linked_nodes.hpp"
#include "edgewise/layout_parts/node_store.hpp"

namespace edgewise {

/// Asks for node after node: each vertex and its cone, then the edges, then each face and its cone; then ties
/// edges to what was there before them. Numbers are left for the layout to write.
template <class Stored>
class LinkedBuilder {
    using Nodes = LinkedNodes<Stored>;

  public:
    LinkedBuilder(const Polyhedron& body, bool features, NodeStore& store)
        : body_(body), store_(store), spokes_(body.vertex_ring.size()), cones_(body.vertex_ring.size()) {
        for (Index v = 0; v < body.vertex_count(); ++v) add_vertex(v, features);
        for (HalfEdge h = 0; h < spokes_.size(); ++h) spokes_[h]->neighbour = vertices_[body.head(h)];
        if (!features) return;
        while (edges_.size() < body.edge_count()) edges_.push_back(make<typename Nodes::Edge>());
        for (Index f = 0; f < body.face_count(); ++f) add_face(f);
        for (Index e = 0; e < body.edge_count(); ++e) link_edge(e, *edges_[e]);
    }

    [[nodiscard]] auto* first_vertex() const { return vertices_[0]; }
    [[nodiscard]] auto* first_face() const { return faces_.empty() ? nullptr : faces_[0]; }

  private:
    template <class Node>
    Node* make() {
        return store_.make<Node>(Node::shares());
    }
    void add_vertex(Index v, bool features) {
        auto* const node = make<typename Nodes::Vertex>();
        node->index = v;
        if (v > 0) vertices_.back()->next = node;
        vertices_.push_back(node);
        typename Nodes::Spoke** to = &node->spokes;
        for (const HalfEdge h : body_.ring_of_vertex(v)) {
            spokes_[h] = features ? make<typename Nodes::VertexCone>() : make<typename Nodes::Spoke>();
            *to = spokes_[h];
            to = &spokes_[h]->next;
        }
    }
    void add_face(Index f) {
        auto* const node = make<typename Nodes::Face>();
        if (f > 0) faces_.back()->next = node;
        faces_.push_back(node);
        typename Nodes::FaceCone** to = &node->cone;
        for (const HalfEdge h : body_.ring_of_face(f)) {
            *to = cones_[h] = make<typename Nodes::FaceCone>();
            to = &cones_[h]->next;
        }
    }
    void link_edge(Index e, typename Nodes::Edge& node) {
        for (const HalfEdge k : {0U, 1U}) {  // the half-edge from the tail has the left face
            const HalfEdge h = 2 * e + k;
            auto* const at_end = static_cast<typename Nodes::VertexCone*>(spokes_[h]);
            at_end->edge = &node;
            node.end[k] = vertices_[body_.tail(h)];
            node.vertex_cone[k] = at_end;
            if (body_.face(h) == no_face) continue;
            cones_[h]->edge = &node;
            node.side[k] = faces_[body_.face(h)];
            node.face_cone[k] = cones_[h];
        }
    }

    const Polyhedron& body_;
    NodeStore& store_;
    std::vector<typename Nodes::Vertex*> vertices_;
    std::vector<typename Nodes::Edge*> edges_;
    std::vector<typename Nodes::Face*> faces_;
    std::vector<typename Nodes::Spoke*> spokes_;    // by the half-edge that leaves the vertex
    std::vector<typename Nodes::FaceCone*> cones_;  // by the half-edge of the face
};

}  // namespace edgewise
