// SPDX-License-Identifier: MIT
//
// How an edge runs over a face's plane. V-F, E-F and E-E must agree on "towards the plane" to the last bit,
// or the pair cycles between them: so all of them ask for the product of the edge's own direction
// with the normal turned into the edge's frame, and nothing else.
#pragma once

#include "edgewise/algorithms/vclip/body.hpp"

namespace edgewise::vclip {

/// Slope of the body's edge, tail to head, over a plane of the other body with this normal.
template <class Table>
[[nodiscard]] ComputeOf<Table> slope_over(const Body<Table>& body, const Vec3<ComputeOf<Table>>& normal) {
    return dot(body.table.direction(body.feature.edge()), body.from_other.direction(normal));
}

/// Signed height over the plane at a place of the segment.
template <class Plane, class Scalar>
[[nodiscard]] Scalar height_at(const Plane& plane, const Segment<Scalar>& segment, Scalar lambda) {
    const Scalar tail = plane.distance(segment.tail);
    return tail + lambda * (plane.distance(segment.head) - tail);
}

}  // namespace edgewise::vclip
