// SPDX-License-Identifier: MIT
//
// A body with fewer vertices, and by how much every distance to it can be wrong: exactly, and to one side.
//
// The smaller body Q is the hull of some of the vertices of the body P, so Q lies in P: it does not contain
// P, and distances to it are never too short. Let h be the largest distance of a vertex of P from Q. Then for
// every other body B:  d(P,B) <= d(Q,B) <= d(P,B) + h, and h is attained:
//   - Q in P, so the points of Q are among those of P: the first inequality.
//   - The distance from a convex set is a convex function, and a convex function on P is largest at one of
//   P's
//     vertices: so every point of P is within h of some point of Q. A closest point of P to B is; by the
//     triangle inequality B is within d(P,B) + h of Q: the second.
//   - Take for B the vertex where h is attained: d(P,B) = 0 and d(Q,B) = h.
// So h, the directed Hausdorff distance from P to Q, is the worst error of a distance. Vertices of Q have
// distance 0; the largest over the others is computed in exact arithmetic (truth/exact_distance).
//
// Choice of vertices: first four that span a solid (far ends, the farthest from their line, the farthest from
// the plane through these three), then the farthest from the chosen ones (Gonzalez 1985, clustering to
// minimise the maximum intercluster distance); for a tolerance, vertices that it does not need are taken out
// again. The choice is greedy: fewer vertices may be enough.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise::studies::advise {

struct SmallerBody {
    std::vector<Vec3d> vertices;
    double worst_error =
        0;  ///< exact: of any distance to it, in the body's unit; never too short, at most so long
};

/// Returns one body for each count below the body's own, ascending from 4. The body must be a solid.
[[nodiscard]] std::vector<SmallerBody> smaller_bodies(const Polyhedron& body,
                                                      const std::vector<std::size_t>& counts);

/// Returns a body with at most `most` vertices; fewer if these already give the whole body.
[[nodiscard]] SmallerBody within_count(const Polyhedron& body, std::size_t most);

/// Returns a solid of few vertices with a worst error of at most the tolerance.
[[nodiscard]] SmallerBody within_tolerance(const Polyhedron& body, double tolerance);

/// Returns the largest exact distance of any of the points from the hull of the subset.
[[nodiscard]] double worst_error_of(const std::vector<Vec3d>& points, const std::vector<Vec3d>& subset);

// Cost of the queries of a body: time, bytes of its table, lines. Queries are of cold pairs of two equal
// bodies. All bodies are timed in turn in rounds; the shortest time of each body counts.

struct BodyCost {
    double ns = 0, table_bytes = 0, lines = 0;  ///< ns and lines per query
};

/// Returns the costs in the bodies' order. Throws std::invalid_argument where a table cannot hold a body.
[[nodiscard]] std::vector<BodyCost> costs_of(std::span<const Polyhedron> bodies, const bench::TableType& type,
                                             const std::string& algorithm);

}  // namespace edgewise::studies::advise
