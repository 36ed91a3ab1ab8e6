// SPDX-License-Identifier: MIT
//
// Clipping an edge to a Voronoi region (Mirtich, MERL TR-97-05, Algorithm 1): the part [low, high] of the
// edge's parameter that lies inside all planes seen so far, and which neighbour bounds it at either end.
#pragma once

#include <cassert>
#include <cstdint>
#include <optional>

#include "edgewise/geometry/vec.hpp"

namespace edgewise::vclip {

enum class Clipped : std::uint8_t {
    inside,              ///< a part of the edge is left
    simply_excluded,     ///< both ends lie beyond this plane
    compoundly_excluded  ///< nothing is left, but no single plane did it
};

/// Neighbour: what lies beyond a plane; copied, never looked into.
template <class Scalar, class Neighbour>
struct Clip {
    Scalar low = 0, high = 1;
    std::optional<Neighbour> at_low, at_high;

    /// Distances of tail and head from a plane, positive inside. The only divisions of the algorithm; the
    /// divisor is never smaller than the dividend.
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

/// Where along the edge (in units of its length) a point projects: the distance to the point falls before and
/// rises after.
template <class Scalar>
[[nodiscard]] Scalar projection(const Vec3<Scalar>& tail, const Vec3<Scalar>& along,
                                const Vec3<Scalar>& point) {
    return dot(Vec3<Scalar>(point - tail), along) / squared_norm(along);
}

}  // namespace edgewise::vclip
