// SPDX-License-Identifier: MIT
//
// The planes of an edge where directions and normals of faces are at hand and planes are not stored: through
// a vertex, unit normals; as layout_parts/voronoi.hpp has them.
#pragma once

#include "edgewise/layout_parts/derived/derived_planes.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// Across the edge, beyond that end, which is at `point`; `along` has unit length, tail to head.
template <class Scalar>
[[nodiscard]] AnchoredPlane<Scalar> plane_beyond(End end, const Vec3<Scalar>& along,
                                                 const Vec3<Scalar>& point) {
    return {end == End::head ? along : Vec3<Scalar>(-along), point};
}

/// Square to the face, through the edge, positive on the face's side.
template <class Scalar>
[[nodiscard]] AnchoredPlane<Scalar> plane_beside(Side side, const Vec3<Scalar>& along,
                                                 const Vec3<Scalar>& face_normal, const Vec3<Scalar>& tail) {
    const Vec3<Scalar> into = cross(face_normal, side == Side::left ? along : Vec3<Scalar>(-along));
    return {into / norm(into), tail};
}

/// Beside an edge without a face: negative everywhere.
template <class Scalar>
[[nodiscard]] AnchoredPlane<Scalar> plane_beside_nothing(const Vec3<Scalar>& tail) {
    return {Vec3<Scalar>::Zero(), tail, -1};
}

}  // namespace edgewise
