// SPDX-License-Identifier: MIT
//
// A floor for the work of a query: what it takes to prove the right distance once it is known, with the
// answer as a hint and nothing sought.
//
// Of separated bodies: that no vertex of A reaches farther along the answer's direction, and none of B
// farther against it. If a body is known to be convex, and a vertex's neighbours are known, a vertex that is
// no lower than its neighbours is the highest; so one vertex of the nearest feature is read, that of the
// fewest neighbours, and these. A table that stores no neighbours is read whole. Each vertex read takes one
// dot product of 5 flops; the direction into B's frame 15; the offset of the frames along it, and the sum of
// the three, 7. Comparisons are no flops here.
//
// Of bodies in contact: a point in both. Five vertices of the two bodies together are enough (Kirchberger's
// theorem), and in general position needed, with their weights as the hint: 3 (2 x 5 - 2) flops for the two
// weighted sums and 18 for B's into A's frame.
//
// Lines: the fewest lines of 64 bytes that the coordinates of these vertices can fill, table by table,
// however a layout places them. Not counted are neighbours' numbers, poses, pair caches.
//
// The floor does not bound every proof. A table that stores planes proves the side of a face by its plane
// alone; and to find the answer is not to prove it. It is the floor of proofs by heights of vertices, to
// which all contenders are compared.
#pragma once

#include <span>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/measure/expected.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::studies {

/// Means per query.
struct ProofFloor {
    double vertices = 0, flops = 0, lines = 0;
};

/// What of a table the floor depends on.
struct ProofReads {
    bool knows_neighbours = true;
    double vertex_bytes = 0;  ///< of the coordinates of one vertex
};

/// Vertices that a proof reads that nothing of the body is higher along `direction` (in its frame).
[[nodiscard]] std::size_t proof_vertices(const Polyhedron& body, const Vec3d& direction,
                                         bool knows_neighbours);

/// Computes the floor over all queries of the workload, with these bodies. Unknown: without queries.
[[nodiscard]] measure::Expected<ProofFloor> proof_floor(const scene::Workload& workload,
                                                        std::span<const Polyhedron> bodies,
                                                        const ProofReads& reads);

}  // namespace edgewise::studies
