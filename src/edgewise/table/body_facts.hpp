// SPDX-License-Identifier: MIT
//
// The few facts of a body that every table keeps beside its arrays: with them, where the arrays lie can be
// computed again.
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
    Parts parts = Parts::support;
    Index vertex_count = 0, neighbour_count = 0;                ///< of the rings of all vertices
    Index edge_count = 0, face_count = 0, face_ring_count = 0;  ///< 0 in a table without features
    double reach = 0;             ///< largest coordinate: what the rounding of planes is relative to
    bool strictly_convex = true;  ///< false: climbs may stick and Voronoi regions go on inside
    std::uint32_t identity = 0;   ///< of the table; refitting keeps it

    BodyFacts() = default;
    /// `strict_turn`: that of the stored scalar (tolerance.hpp).
    BodyFacts(const Polyhedron& body, Parts held, double strict_turn)
        : parts(held),
          vertex_count(static_cast<Index>(body.vertex_count())),
          neighbour_count(static_cast<Index>(body.vertex_ring.size())),
          strictly_convex(is_strictly_convex(body, strict_turn)),
          identity(next_table_identity()) {
        for (const Vec3d& v : body.vertices) reach = std::max(reach, max_abs(v));
        if (parts == Parts::support) return;
        edge_count = static_cast<Index>(body.edge_count());
        face_count = static_cast<Index>(body.face_count());
        face_ring_count = static_cast<Index>(body.face_ring.size());
    }

    /// Of another body of the same topology, in the same table.
    [[nodiscard]] BodyFacts refitted(const Polyhedron& body, double strict_turn) const {
        BodyFacts facts(body, parts, strict_turn);
        assert(facts.vertex_count == vertex_count && facts.neighbour_count == neighbour_count);
        facts.identity = identity;
        return facts;
    }
};

}  // namespace edgewise
