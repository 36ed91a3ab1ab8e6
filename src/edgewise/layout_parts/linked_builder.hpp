// SPDX-License-Identifier: MIT
//
// Builds the nodes of a table of nodes and pointers, one by one, and ties them together.
#pragma once

#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/linked_body.hpp"
#include "edgewise/layout_parts/linked_nodes.hpp"

namespace edgewise {

/// Allocates node after node: each vertex and its cone, then the edges, then each face and its cone; then
/// links edges to the nodes before them. The layout writes the numbers later.
template <class NodePlaces>
class LinkedBuilder {
    using Nodes = typename NodePlaces::Nodes;
    using Vertex = typename Nodes::Vertex;
    using Edge = typename Nodes::Edge;
    using Face = typename Nodes::Face;
    using Spoke = typename Nodes::Spoke;
    using VertexCone = typename Nodes::VertexCone;
    using FaceCone = typename Nodes::FaceCone;
    using F = NodeField;

  public:
    LinkedBuilder(const Polyhedron& body, bool features, LinkedBody<NodePlaces>& nodes)
        : body_(body), nodes_(nodes), spokes_(body.vertex_ring.size()), cones_(body.vertex_ring.size()) {
        for (Index v = 0; v < body.vertex_count(); ++v) add_vertex(v, features);
        for (HalfEdge h = 0; h < spokes_.size(); ++h) at<F::neighbour>(spokes_[h]) = vertices_[body.head(h)];
        if (!features) return;
        for (Index e = 0; e < body.edge_count(); ++e) add_edge(e);
        for (Index f = 0; f < body.face_count(); ++f) add_face(f);
        for (Index e = 0; e < body.edge_count(); ++e) link_faces(e, edges_[e]);
    }

  private:
    template <NodeField field, class Node>
    [[nodiscard]] auto& at(Node* node) const {
        return nodes_.template at<field>(node);
    }

    void add_vertex(Index v, bool features) {
        auto* const node = nodes_.template make<Vertex>();
        at<F::index>(node) = v;
        (v > 0 ? at<F::next_vertex>(vertices_.back()) : nodes_.first_vertex) = node;
        vertices_.push_back(node);
        Spoke** to = &at<F::spokes>(node);
        for (const HalfEdge h : body_.ring_of_vertex(v)) {
            spokes_[h] = features ? nodes_.template make<VertexCone>() : nodes_.template make<Spoke>();
            *to = spokes_[h];
            to = &at<F::next_spoke>(spokes_[h]);
        }
    }
    void add_face(Index f) {
        auto* const node = nodes_.template make<Face>();
        (f > 0 ? at<F::next_face>(faces_.back()) : nodes_.first_face) = node;
        faces_.push_back(node);
        FaceCone** to = &at<F::cone>(node);
        for (const HalfEdge h : body_.ring_of_face(f)) {
            *to = cones_[h] = nodes_.template make<FaceCone>();
            to = &at<F::next_side>(cones_[h]);
        }
    }
    void add_edge(Index e) {
        auto* const node = nodes_.template make<Edge>();
        edges_.push_back(node);
        at<F::tail>(node) = vertices_[body_.tail(2 * e)];
        at<F::head>(node) = vertices_[body_.tail(2 * e + 1)];
        tie_cone(at<F::tail_cone>(node), 2 * e, node);
        tie_cone(at<F::head_cone>(node), 2 * e + 1, node);
    }
    void tie_cone(VertexCone*& cone, HalfEdge h, Edge* edge) {
        cone = static_cast<VertexCone*>(spokes_[h]);
        at<F::vertex_edge>(cone) = edge;
    }
    /// Links both faces: the half-edge from the tail has the left face.
    void link_faces(Index e, Edge* node) {
        link_face(2 * e, node, at<F::left>(node), at<F::left_cone>(node));
        link_face(2 * e + 1, node, at<F::right>(node), at<F::right_cone>(node));
    }
    void link_face(HalfEdge h, Edge* node, Face*& face, FaceCone*& cone) {
        if (body_.face(h) == no_face) return;
        at<F::side_edge>(cones_[h]) = node;
        face = faces_[body_.face(h)];
        cone = cones_[h];
    }

    const Polyhedron& body_;
    LinkedBody<NodePlaces>& nodes_;
    std::vector<Vertex*> vertices_;
    std::vector<Edge*> edges_;
    std::vector<Face*> faces_;
    std::vector<Spoke*> spokes_;    // by the half-edge that leaves the vertex
    std::vector<FaceCone*> cones_;  // by the half-edge of the face
};

}  // namespace edgewise
