// SPDX-License-Identifier: MIT
//
// The Voronoi planes of an edge, derived once in double from the canonical body; what storing layouts store.
// Plane names follow Mirtich's V-Clip report (MERL TR-97-05, section 3.1), orientation table/contract.hpp.
#pragma once

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

struct EdgeGeometry {
    Vec3d direction;  ///< unit, tail to head
    double length;
    Plane<double> tail_plane, head_plane;   ///< positive beyond that end
    Plane<double> left_plane, right_plane;  ///< positive on the side of that face
};

[[nodiscard]] inline Plane<double> plane_through(const Vec3d& normal, const Vec3d& point) {
    return {normal, -dot(normal, point)};
}

[[nodiscard]] inline EdgeGeometry edge_geometry(const Polyhedron& body, Index e) {
    const PolyhedronEdge& edge = body.edges[e];
    const Vec3d& tail = body.vertices[edge.tail];
    const Vec3d& head = body.vertices[edge.head];
    const Vec3d along = head - tail;

    EdgeGeometry result;
    result.length = norm(along);
    result.direction = along / result.length;
    result.tail_plane = plane_through(-result.direction, tail);
    result.head_plane = plane_through(result.direction, head);
    // Seen from outside, the left face lies to the left of tail -> head: n_left x direction points into it.
    const auto into_left = cross(body.face_planes[edge.left].normal, result.direction);
    const auto into_right = cross(result.direction, body.face_planes[edge.right].normal);
    result.left_plane = plane_through(into_left / norm(into_left), tail);
    result.right_plane = plane_through(into_right / norm(into_right), tail);
    return result;
}

}  // namespace edgewise
