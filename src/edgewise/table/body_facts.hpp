// SPDX-License-Identifier: MIT
//
// The few facts of a body that every table keeps beside its arrays.
#pragma once

#include <algorithm>

#include "edgewise/geometry/strictly_convex.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise {

struct BodyFacts {
    Index vertex_count = 0;
    Index edge_count = 0, face_count = 0;  ///< 0 in a table without features
    double reach = 0;                      ///< largest coordinate: what the rounding of planes is relative to
    bool strictly_convex = true;           ///< false: climbs may stick and Voronoi regions go on inside

    BodyFacts() = default;
    /// `strict_turn`: that of the stored scalar (tolerance.hpp).
    BodyFacts(const Polyhedron& body, Parts parts, double strict_turn)
        : vertex_count(static_cast<Index>(body.vertex_count())),
          edge_count(parts == Parts::features ? static_cast<Index>(body.edge_count()) : 0),
          face_count(parts == Parts::features ? static_cast<Index>(body.face_count()) : 0),
          strictly_convex(is_strictly_convex(body, strict_turn)) {
        for (const Vec3d& v : body.vertices) reach = std::max(reach, max_abs(v));
    }
};

}  // namespace edgewise
