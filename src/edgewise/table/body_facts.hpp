// SPDX-License-Identifier: MIT
//
// The few facts of a body that every table keeps next to its arrays: from them, the places of the arrays can
// be computed again.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/strictly_convex.hpp"
#include "edgewise/table/identity.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise {

struct BodyFacts {
    double reach = 0;  ///< largest coordinate: the rounding of planes is relative to it
    Index vertex_count = 0, neighbour_count = 0;  ///< `neighbour_count`: entries in the rings of all vertices
    Index face_count = 0;                         ///< 0 in a table without features
    std::uint32_t identity = 0;                   ///< identity of the table; refitting keeps it
    Parts parts = Parts::support;
    bool strictly_convex = true;  ///< false: Voronoi regions continue inside the body
    bool climbable = true;        ///< false: a climb may stop below the highest vertex
    /// Set where planes are derived (layout_parts/derived/thin_corners.hpp): they use wider arithmetic.
    bool thin_corners = false;

    BodyFacts() = default;
    /// `strict_turn`: least turn of the stored scalar (tolerance.hpp).
    BodyFacts(const Polyhedron& body, Parts held, double strict_turn)
        : vertex_count(static_cast<Index>(body.vertex_count())),
          neighbour_count(static_cast<Index>(body.vertex_ring.size())),
          identity(next_table_identity()),
          parts(held),
          strictly_convex(is_strictly_convex(body, strict_turn)),
          climbable(is_climbable(body)) {
        for (const Vec3d& v : body.vertices) reach = std::max(reach, max_abs(v));
        if (parts == Parts::support) return;
        face_count = static_cast<Index>(body.face_count());
        assert(edge_count() == body.edge_count() && face_ring_count() == body.face_ring.size());
    }

    /// Number of edges, 0 in a table without features; each edge is in the rings of its two ends.
    [[nodiscard]] Index edge_count() const { return parts == Parts::features ? neighbour_count / 2 : 0; }
    /// Entries in the rings of all faces; each edge is in those of its two faces, if there are any.
    [[nodiscard]] Index face_ring_count() const { return face_count > 0 ? neighbour_count : 0; }

    /// Facts of another body of the same topology, in the same table.
    [[nodiscard]] BodyFacts refitted(const Polyhedron& body, double strict_turn) const {
        BodyFacts facts(body, parts, strict_turn);
        assert(facts.vertex_count == vertex_count && facts.neighbour_count == neighbour_count);
        facts.identity = identity;
        return facts;
    }
};

}  // namespace edgewise
