// SPDX-License-Identifier: MIT
//
// The canonical body as a feature table: no memory of its own, every plane derived when asked. For tests of
// what is written against the contract and names no layout.
#pragma once

#include "edgewise/geometry/strictly_convex.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/layout_parts/voronoi.hpp"
#include "edgewise/table/canonical.hpp"

namespace edgewise {

class ReferenceTable : public Canonical {
    // First, because what follows needs its deduced type.
    static auto ring(const std::vector<Index>& offset, const std::vector<HalfEdge>& entries, Index row) {
        return IndexedRing(offset[row], offset[row + 1], [&entries](Index at) {
            return RingEdge<Edge>{entries[at] >> 1, (entries[at] & 1) != 0};
        });
    }

  public:
    using Edge = Index;
    using Face = Index;
    static constexpr Face no_face = edgewise::no_face;

    explicit ReferenceTable(const Polyhedron& body) : Canonical(body), body_(&body) {}

    [[nodiscard]] double reach() const { return extent(body_->vertices) + max_abs(body_->vertices[0]); }
    [[nodiscard]] bool strictly_convex() const {
        return is_strictly_convex(*body_, Tolerance<double>::strict_turn);
    }
    [[nodiscard]] Vertex tail(Edge e) const { return body_->edges[e].tail; }
    [[nodiscard]] Vertex head(Edge e) const { return body_->edges[e].head; }
    [[nodiscard]] Face left(Edge e) const { return body_->edges[e].left; }
    [[nodiscard]] Face right(Edge e) const { return body_->edges[e].right; }
    [[nodiscard]] Vec3d direction(Edge e) const { return edge_geometry(*body_, e).direction; }
    [[nodiscard]] auto all_faces() const { return index_range(static_cast<Index>(body_->face_count())); }

    [[nodiscard]] auto ring_of_vertex(Vertex v) const {
        return ring(body_->vertex_offset, body_->vertex_ring, v);
    }
    [[nodiscard]] auto ring_of_face(Face f) const { return ring(body_->face_offset, body_->face_ring, f); }

    [[nodiscard]] Plane<double> vertex_edge_plane(Edge e, End end) const {
        const EdgeGeometry g = edge_geometry(*body_, e);
        return end == End::tail ? g.tail_plane : g.head_plane;
    }
    [[nodiscard]] Plane<double> edge_face_plane(Edge e, Side side) const {
        const EdgeGeometry g = edge_geometry(*body_, e);
        return side == Side::left ? g.left_plane : g.right_plane;
    }
    [[nodiscard]] Plane<double> face_plane(Face f) const { return body_->face_planes[f]; }

  private:
    const Polyhedron* body_;
};

static_assert(FeatureTable<ReferenceTable>);

}  // namespace edgewise
