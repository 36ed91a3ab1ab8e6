// SPDX-License-Identifier: MIT
//
// Builds the nodes of the layout `linked`, one by one, and ties them together.
#pragma once

#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/linked_body.hpp"
#include "edgewise/layout_parts/linked_nodes.hpp"

namespace edgewise {

/// Asks for node after node: each vertex and its cone, then the edges, then each face and its cone; then ties
/// edges to what was there before them. Numbers are left for the layout to write.
template <class Stored>
class LinkedBuilder {
    using Nodes = LinkedNodes<Stored>;

  public:
    LinkedBuilder(const Polyhedron& body, bool features, LinkedBody<Stored>& nodes)
        : body_(body), nodes_(nodes), spokes_(body.vertex_ring.size()), cones_(body.vertex_ring.size()) {
        for (Index v = 0; v < body.vertex_count(); ++v) add_vertex(v, features);
        for (HalfEdge h = 0; h < spokes_.size(); ++h) spokes_[h]->neighbour = vertices_[body.head(h)];
        if (!features) return;
        for (Index e = 0; e < body.edge_count(); ++e) add_edge(e);
        for (Index f = 0; f < body.face_count(); ++f) add_face(f);
        for (Index e = 0; e < body.edge_count(); ++e) link_faces(e, *edges_[e]);
    }

  private:
    void add_vertex(Index v, bool features) {
        auto* const node = nodes_.template make<typename Nodes::Vertex>();
        node->index = v;
        (v > 0 ? vertices_.back()->next : nodes_.first_vertex) = node;
        vertices_.push_back(node);
        typename Nodes::Spoke** to = &node->spokes;
        for (const HalfEdge h : body_.ring_of_vertex(v)) {
            spokes_[h] = features ? nodes_.template make<typename Nodes::VertexCone>()
                                  : nodes_.template make<typename Nodes::Spoke>();
            *to = spokes_[h];
            to = &spokes_[h]->next;
        }
    }
    void add_face(Index f) {
        auto* const node = nodes_.template make<typename Nodes::Face>();
        (f > 0 ? faces_.back()->next : nodes_.first_face) = node;
        faces_.push_back(node);
        typename Nodes::FaceCone** to = &node->cone;
        for (const HalfEdge h : body_.ring_of_face(f)) {
            *to = cones_[h] = nodes_.template make<typename Nodes::FaceCone>();
            to = &cones_[h]->next;
        }
    }
    void add_edge(Index e) {
        auto* const node = nodes_.template make<typename Nodes::Edge>();
        edges_.push_back(node);
        for (const HalfEdge k : {0U, 1U}) {
            const HalfEdge h = 2 * e + k;
            node->end[k] = vertices_[body_.tail(h)];
            node->vertex_cone[k] = static_cast<typename Nodes::VertexCone*>(spokes_[h]);
            node->vertex_cone[k]->edge = node;
        }
    }
    void link_faces(Index e, typename Nodes::Edge& node) {
        for (const HalfEdge k : {0U, 1U}) {  // the half-edge from the tail has the left face
            const HalfEdge h = 2 * e + k;
            if (body_.face(h) == no_face) continue;
            cones_[h]->edge = &node;
            node.side[k] = faces_[body_.face(h)];
            node.face_cone[k] = cones_[h];
        }
    }

    const Polyhedron& body_;
    LinkedBody<Stored>& nodes_;
    std::vector<typename Nodes::Vertex*> vertices_;
    std::vector<typename Nodes::Edge*> edges_;
    std::vector<typename Nodes::Face*> faces_;
    std::vector<typename Nodes::Spoke*> spokes_;    // by the half-edge that leaves the vertex
    std::vector<typename Nodes::FaceCone*> cones_;  // by the half-edge of the face
};

}  // namespace edgewise
