// SPDX-License-Identifier: MIT
//
// Builds the nodes of the layout `linked` one by one, ties them together, and writes a body's numbers into
// them.
#pragma once

#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/linked_nodes.hpp"
#include "edgewise/layout_parts/voronoi.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise {

/// Allocates node after node: each vertex and its cone, then the edges, then each face and its cone; then
/// links edges to the nodes before them. write_numbers() writes the numbers later.
template <class Stored>
class LinkedBuilder {
    using Nodes = LinkedNodes<Stored>;
    using Vertex = typename Nodes::Vertex;
    using Edge = typename Nodes::Edge;
    using Face = typename Nodes::Face;
    using Spoke = typename Nodes::Spoke;
    using VertexCone = typename Nodes::VertexCone;
    using FaceCone = typename Nodes::FaceCone;

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
        auto* const node = nodes_.template make<Vertex>();
        node->index = v;
        (v > 0 ? vertices_.back()->next : nodes_.first_vertex) = node;
        vertices_.push_back(node);
        Spoke** to = &node->spokes;
        for (const HalfEdge h : body_.ring_of_vertex(v)) {
            spokes_[h] = features ? nodes_.template make<VertexCone>() : nodes_.template make<Spoke>();
            *to = spokes_[h];
            to = &spokes_[h]->next;
        }
    }
    void add_face(Index f) {
        auto* const node = nodes_.template make<Face>();
        (f > 0 ? faces_.back()->next : nodes_.first_face) = node;
        faces_.push_back(node);
        FaceCone** to = &node->cone;
        for (const HalfEdge h : body_.ring_of_face(f)) {
            *to = cones_[h] = nodes_.template make<FaceCone>();
            to = &cones_[h]->next;
        }
    }
    void add_edge(Index e) {
        auto* const node = nodes_.template make<Edge>();
        edges_.push_back(node);
        node->tail = vertices_[body_.tail(2 * e)];
        node->head = vertices_[body_.tail(2 * e + 1)];
        node->tail_cone = cone_of(2 * e, node);
        node->head_cone = cone_of(2 * e + 1, node);
    }
    /// Returns the cone of a half-edge, and ties it to the edge.
    [[nodiscard]] VertexCone* cone_of(HalfEdge h, Edge* edge) const {
        auto* const cone = static_cast<VertexCone*>(spokes_[h]);
        cone->edge = edge;
        return cone;
    }
    /// Links both faces: the half-edge from the tail has the left face.
    void link_faces(Index e, Edge& node) const {
        link_face(2 * e, node, node.left, node.left_cone);
        link_face(2 * e + 1, node, node.right, node.right_cone);
    }
    void link_face(HalfEdge h, Edge& node, Face*& face, FaceCone*& cone) const {
        if (body_.face(h) == no_face) return;
        cones_[h]->edge = &node;
        face = faces_[body_.face(h)];
        cone = cones_[h];
    }

    const Polyhedron& body_;
    LinkedBody<Stored>& nodes_;
    std::vector<Vertex*> vertices_;
    std::vector<Edge*> edges_;
    std::vector<Face*> faces_;
    std::vector<Spoke*> spokes_;    // by the half-edge that leaves the vertex
    std::vector<FaceCone*> cones_;  // by the half-edge of the face
};

/// Writes an edge's numbers: its planes into its cones.
template <class Stored>
void write_linked_edge(typename LinkedNodes<Stored>::Edge& edge, const EdgeGeometry& g) {
    edge.direction = cast<Stored>(g.direction);
    edge.length = static_cast<Stored>(g.length);
    edge.tail_cone->plane = cast<Stored>(g.tail_plane);
    edge.head_cone->plane = cast<Stored>(g.head_plane);
    if (edge.left_cone) edge.left_cone->plane = cast<Stored>(g.left_plane);
    if (edge.right_cone) edge.right_cone->plane = cast<Stored>(g.right_plane);
}

/// Writes a body's numbers into nodes with their topology complete. Lists are in the body's order, and an
/// edge is written at its tail.
template <class Stored>
void write_numbers(const LinkedBody<Stored>& nodes, Parts parts, const Polyhedron& body) {
    using VertexCone = typename LinkedNodes<Stored>::VertexCone;
    auto* vertex = nodes.first_vertex;
    for (Index v = 0; vertex; vertex = vertex->next, ++v) {
        vertex->point = cast<Stored>(body.vertices[v]);
        if (parts == Parts::support) continue;
        auto* spoke = vertex->spokes;
        for (const HalfEdge h : body.ring_of_vertex(v)) {
            const bool leaves = (h & 1) == 0;
            if (leaves)
                write_linked_edge<Stored>(*static_cast<VertexCone*>(spoke)->edge,
                                          edge_geometry(body, h >> 1));
            spoke = spoke->next;
        }
    }
    auto* face = nodes.first_face;
    for (Index f = 0; face; face = face->next, ++f) face->plane = cast<Stored>(body.face_planes[f]);
}

}  // namespace edgewise
