// SPDX-License-Identifier: MIT
//
// A floor for the work of a query: the work of a proof that the distance is right. The proof receives the
// answer as a hint, so it does not search.
//
// Separated bodies: the proof shows that no vertex of A is farther along the answer's direction, and no
// vertex of B farther against it. In a convex body a vertex that is no lower than its neighbours is the
// highest. So the proof reads one vertex of the nearest feature (the one with the fewest neighbours) and its
// neighbours. A table that stores no neighbours is read whole. Each vertex read takes one dot product of 5
// flops. Turning the direction into B's frame takes 15; the offset of the frames along it, and the sum of the
// three terms, take 7. Comparisons are no flops.
//
// Bodies in contact: the proof shows a point in both. Five vertices of the two bodies together are enough
// (Kirchberger's theorem), and needed in general position. Their weights are the hint: 3 (2 x 5 - 2) flops
// for the two weighted sums, and 18 to turn B's sum into A's frame.
//
// Lines: the fewest lines of 64 bytes that the coordinates of the vertices read can fill, table by table, in
// any layout. Neighbours' numbers, poses and pair caches are not counted.
//
// The floor does not bound every proof. A table that stores planes proves the side of a face by its plane
// alone; and a query must also find the answer. It is the floor of proofs by heights of vertices; all cells
// are compared to it.
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
