// SPDX-License-Identifier: MIT
//
// The canonical body itself as a support table: no memory of its own. For tools that need a distance now and
// then (placing pairs in a scene), and as the reference that contract tests compare every layout with.
#pragma once

#include <cstddef>

#include "edgewise/table/contract.hpp"

namespace edgewise {

class Canonical {
  public:
    using PrecisionType = f64;
    using Vertex = Index;
    static constexpr bool counts_vertices = true;

    /// Borrows the body, which must outlive this object; a temporary one does not compile.
    explicit Canonical(const Polyhedron& body) : body_(&body) {}
    explicit Canonical(const Polyhedron&&) = delete;

    [[nodiscard]] std::size_t vertex_count() const { return body_->vertex_count(); }
    /// Always false, without a check: a scan is right for any body.
    [[nodiscard]] bool strictly_convex() const { return false; }
    [[nodiscard]] Vertex first_vertex() const { return 0; }
    [[nodiscard]] Index index_of(Vertex v) const { return v; }
    [[nodiscard]] Vec3d vertex(Vertex v) const { return body_->vertices[v]; }
    [[nodiscard]] auto all_vertices() const { return index_range(static_cast<Index>(vertex_count())); }
    [[nodiscard]] auto neighbours(Vertex v) const {
        return IndexedRing(body_->vertex_offset[v], body_->vertex_offset[v + 1],
                           [body = body_](Index at) { return body->head(body->vertex_ring[at]); });
    }

  private:
    const Polyhedron* body_;
};

static_assert(ClimbingTable<Canonical>);

}  // namespace edgewise
