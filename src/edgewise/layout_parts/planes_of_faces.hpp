// SPDX-License-Identifier: MIT
//
// The planes of an edge for tables that store directions and normals of faces, but no planes: through a
// vertex, with unit normals; as in layout_parts/voronoi.hpp.
#pragma once

#include "edgewise/layout_parts/derived/derived_planes.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

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
