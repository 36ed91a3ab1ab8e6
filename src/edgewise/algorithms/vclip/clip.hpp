// SPDX-License-Identifier: MIT
//
// Clipping an edge to a Voronoi region (Mirtich, MERL TR-97-05, Algorithm 1): the part [low, high] of the
// edge's parameter that lies inside all planes so far, and the neighbour that bounds it at either end.
#pragma once

#include <cassert>
#include <cstdint>
#include <optional>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/geometry/vec.hpp"

namespace edgewise::vclip {

enum class Clipped : std::uint8_t {
    inside,              ///< a part of the edge is left
    simply_excluded,     ///< both ends lie beyond this plane
    compoundly_excluded  ///< nothing is left, but no single plane did it
};

/// Neighbour: the feature beyond a plane; copied, never read.
template <class Scalar, class Neighbour>
struct Clip {
    Scalar low = 0, high = 1;
    std::optional<Neighbour> at_low, at_high;

    /// Clips by the distances of tail and head from a plane, positive inside. Has the only divisions of the
    /// algorithm; the divisor is never smaller than the dividend.
    [[nodiscard]] Clipped against(Scalar tail, Scalar head, const Neighbour& beyond) {
        if (tail < 0 && head < 0) return Clipped::simply_excluded;
        if (tail < 0) {
            const Scalar lambda = tail / (tail - head);
            if (lambda > low) {
                low = lambda;
                at_low = beyond;
            }
        } else if (head < 0) {
            const Scalar lambda = tail / (tail - head);
            if (lambda < high) {
                high = lambda;
                at_high = beyond;
            }
        }
        assert(low >= 0 && low <= 1 && high >= 0 && high <= 1);
        return low > high ? Clipped::compoundly_excluded : Clipped::inside;
    }
};

/// Parameter along the edge (in units of its length) at which a point projects: the distance to the point
/// falls before and rises after.
template <class Scalar>
[[nodiscard]] Scalar projection(const Vec3<Scalar>& tail, const Vec3<Scalar>& along,
                                const Vec3<Scalar>& point) {
    return dot(Vec3<Scalar>(point - tail), along) / squared_norm(along);
}

/// Derivative test against a vertex (TR-97-05, Algorithm 2): the sign of change of the distance from it along
/// the edge, where the edge crosses a plane through the vertex with this normal (any length); 0 within
/// rounding. `from_vertex` leads there. Departure: the report compares where the edge is clipped with where
/// the vertex projects, which is off by the rounding of coordinates over the distance. Here the edge
/// direction's part across the plane is removed first; it is perpendicular to `from_vertex` too. The slope of
/// nearly parallel edges is then accurate to some rounding steps at any distance. Both features of the plane
/// get the same number.
template <class Scalar>
[[nodiscard]] Scalar slope_where_clipped(const Vec3<Scalar>& along, const Vec3<Scalar>& normal,
                                         const Vec3<Scalar>& from_vertex) {
    const Vec3<Scalar> in_plane = along - dot(along, normal) / squared_norm(normal) * normal;
    const Scalar slope = dot(in_plane, from_vertex);
    constexpr Scalar level = Tolerance<Scalar>::vertex_derivative * Tolerance<Scalar>::vertex_derivative;
    return slope * slope <= level * squared_norm(along) * squared_norm(from_vertex) ? Scalar(0) : slope;
}

}  // namespace edgewise::vclip
