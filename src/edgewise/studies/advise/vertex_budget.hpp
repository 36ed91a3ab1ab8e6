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
// Which vertices: first four that span a solid (far ends, the farthest from their line, the farthest from the
// plane of these three), then the farthest from what is there (Gonzalez 1985, clustering to minimise the
// maximum intercluster distance); then, for a tolerance, those are taken out that it does without. Greedy:
// fewer vertices may do.
#pragma once

#include <cstddef>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise::studies::advise {

struct SmallerBody {
    std::vector<Vec3d> vertices;
    double worst_error =
        0;  ///< exact: of any distance to it, in the body's unit; never too short, at most so long
};

/// One for each count that the body has more vertices than, ascending from 4. The body must be a solid.
[[nodiscard]] std::vector<SmallerBody> smaller_bodies(const Polyhedron& body,
                                                      const std::vector<std::size_t>& counts);

/// With so many vertices at most; fewer where these are all that matter.
[[nodiscard]] SmallerBody within_count(const Polyhedron& body, std::size_t most);

/// With as few vertices as are found whose worst error is at most the tolerance; a solid.
[[nodiscard]] SmallerBody within_tolerance(const Polyhedron& body, double tolerance);

/// The largest exact distance of any of the points from the hull of the subset.
[[nodiscard]] double worst_error_of(const std::vector<Vec3d>& points, const std::vector<Vec3d>& subset);

}  // namespace edgewise::studies::advise
