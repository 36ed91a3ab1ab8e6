// SPDX-License-Identifier: MIT
//
// The Voronoi planes of an edge, derived once in double from the canonical body, for layouts that store them;
// and through a vertex, for layouts that store only directions and normals of faces. Plane names follow
// Mirtich's V-Clip report (MERL TR-97-05, section 3.1), orientation table/contract.hpp.
#pragma once

#include <cassert>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/table/contract.hpp"

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

/// Edge-face plane. Seen from outside, a face lies to the left of its edges as its own ring runs them: normal
/// x along points into it. On a side without a face the plane is negative everywhere.
[[nodiscard]] inline Plane<double> edge_face_plane(const Polyhedron& body, Index face, const Vec3d& along,
                                                   const Vec3d& point) {
    if (face == no_face) return {Vec3d::Zero(), -1};
    const Vec3d into = cross(body.face_planes[face].normal, along);
    return plane_through(into / norm(into), point);
}

[[nodiscard]] inline EdgeGeometry edge_geometry(const Polyhedron& body, Index e) {
    assert(e < body.edge_count());
    const PolyhedronEdge& edge = body.edges[e];
    const Vec3d& tail = body.vertices[edge.tail];
    const Vec3d& head = body.vertices[edge.head];
    const Vec3d along = head - tail;

    EdgeGeometry result;
    result.length = norm(along);
    result.direction = along / result.length;
    result.tail_plane = plane_through(-result.direction, tail);
    result.head_plane = plane_through(result.direction, head);
    result.left_plane = edge_face_plane(body, edge.left, result.direction, tail);
    result.right_plane = edge_face_plane(body, edge.right, Vec3d(-result.direction), tail);
    return result;
}

/// The plane through `anchor`; the length of its normal is arbitrary.
template <class Scalar>
struct AnchoredPlane {
    Vec3<Scalar> normal, anchor;
    Scalar offset = 0;

    /// Signed distance, in units of |normal|.
    [[nodiscard]] Scalar distance(const Vec3<Scalar>& p) const {
        return dot(normal, Vec3<Scalar>(p - anchor)) + offset;
    }
};

/// Vertex-edge plane, positive beyond that end, at `point`; `along` has unit length, tail to head.
template <class Scalar>
[[nodiscard]] AnchoredPlane<Scalar> plane_beyond(End end, const Vec3<Scalar>& along,
                                                 const Vec3<Scalar>& point) {
    return {end == End::head ? along : Vec3<Scalar>(-along), point};
}

/// Edge-face plane: perpendicular to the face, through the edge, positive on the face's side.
template <class Scalar>
[[nodiscard]] AnchoredPlane<Scalar> plane_beside(Side side, const Vec3<Scalar>& along,
                                                 const Vec3<Scalar>& face_normal, const Vec3<Scalar>& tail) {
    const Vec3<Scalar> into = cross(face_normal, side == Side::left ? along : Vec3<Scalar>(-along));
    return {into / norm(into), tail};
}

/// Edge-face plane of a side without a face: negative everywhere.
template <class Scalar>
[[nodiscard]] AnchoredPlane<Scalar> plane_beside_nothing(const Vec3<Scalar>& tail) {
    return {Vec3<Scalar>::Zero(), tail, -1};
}

}  // namespace edgewise
