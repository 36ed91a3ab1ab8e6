// SPDX-License-Identifier: MIT
//
// Writes a body's numbers into the nodes of a table of nodes and pointers with its topology complete. Lists
// are in the body's order, and the writer meets an edge at its tail.
#pragma once

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/linked_body.hpp"
#include "edgewise/layout_parts/linked_nodes.hpp"
#include "edgewise/layout_parts/voronoi.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise {

template <class NodePlaces>
class LinkedWriter {
    using Stored = typename NodePlaces::Stored;
    using Nodes = typename NodePlaces::Nodes;
    using F = NodeField;

  public:
    LinkedWriter(const LinkedBody<NodePlaces>& nodes, Parts parts) : nodes_(nodes), parts_(parts) {}

    void write(const Polyhedron& body) const {
        auto* vertex = nodes_.first_vertex;
        for (Index v = 0; vertex != nullptr; vertex = at<F::next_vertex>(vertex), ++v) {
            at<F::point>(vertex) = cast<Stored>(body.vertices[v]);
            if (parts_ == Parts::features) write_edges_of(vertex, body, v);
        }
        auto* face = nodes_.first_face;
        for (Index f = 0; face != nullptr; face = at<F::next_face>(face), ++f)
            at<F::face_plane>(face) = cast<Stored>(body.face_planes[f]);
    }

  private:
    template <NodeField field, class Node>
    [[nodiscard]] auto& at(Node* node) const {
        return nodes_.template at<field>(node);
    }

    void write_edges_of(typename Nodes::Vertex* tail, const Polyhedron& body, Index v) const {
        typename Nodes::Spoke* spoke = at<F::spokes>(tail);
        for (const HalfEdge h : body.ring_of_vertex(v)) {
            auto* const cone = static_cast<typename Nodes::VertexCone*>(spoke);
            const bool leaves = (h & 1) == 0;
            if (leaves) write_edge(at<F::vertex_edge>(cone), edge_geometry(body, h >> 1));
            spoke = at<F::next_spoke>(spoke);
        }
    }
    /// Writes an edge without its planes: the cones keep them.
    void write_edge(typename Nodes::Edge* edge, const EdgeGeometry& g) const {
        at<F::direction>(edge) = cast<Stored>(g.direction);
        at<F::length>(edge) = static_cast<Stored>(g.length);
        at<F::vertex_plane>(at<F::tail_cone>(edge)) = cast<Stored>(g.tail_plane);
        at<F::vertex_plane>(at<F::head_cone>(edge)) = cast<Stored>(g.head_plane);
        auto *const left = at<F::left_cone>(edge), *const right = at<F::right_cone>(edge);
        if (left) at<F::side_plane>(left) = cast<Stored>(g.left_plane);
        if (right) at<F::side_plane>(right) = cast<Stored>(g.right_plane);
    }

    const LinkedBody<NodePlaces>& nodes_;
    Parts parts_;
};

}  // namespace edgewise
