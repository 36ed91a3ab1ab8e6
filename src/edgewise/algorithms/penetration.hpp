// SPDX-License-Identifier: MIT
//
// How deep two bodies overlap: the shortest translation that separates them, by the expanding polytope
// algorithm (EPA). A polytope inside the Minkowski difference A - B grows by support points along the normal
// of its face nearest to the origin, until that face cannot be pushed out any further.
//
// van den Bergen, "Proximity queries and penetration depth computation on 3D game objects", 2001. Departures:
// - the polytope is the exact hull of its points (penetration/polytope.hpp) and computes in double whatever
//   the tables hold, so neither coplanar faces nor slivers need a tolerance;
// - it starts from any tetrahedron with volume, whether or not it holds the origin;
// - it ends when the gain along the nearest face's normal is within the rounding of the support products, or
//   when the farthest point is not above that face; every other step takes in a new vertex of A - B, so it
//   ends;
// - every support plane bounds the depth from above, and the least bound seen is the answer if the work space
//   is full: still a translation that separates the bodies.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "edgewise/algorithms/answerable.hpp"
#include "edgewise/algorithms/penetration/difference.hpp"
#include "edgewise/algorithms/penetration/polytope.hpp"
#include "edgewise/algorithms/simplex_pair.hpp"

namespace edgewise {

/// Everything is in A's frame. B moved by depth * normal touches A. Always <normal, point_a - point_b> =
/// depth; when converged, point_a - point_b = depth * normal, both to rounding: point_a is the point of A
/// deepest in B, point_b the point of B deepest in A.
struct Penetration {
    double depth = 0;              ///< 0: touching, or separated (then along the normal, the points are void)
    Vec3d normal = Vec3d::Zero();  ///< unit; direction in which B must move, outward from A
    Vec3d point_a = Vec3d::Zero();  ///< on the surface of A
    Vec3d point_b = Vec3d::Zero();  ///< on the surface of B
    int steps = 0;                  ///< number of faces examined
    /// False: the work space was full, and the depth is an upper bound; or, with a normal of zero, the pose
    /// cannot be answered (answerable.hpp).
    bool converged = false;
};

/// Heap memory of a query. Reused from one query to the next, it allocates only when a query needs more than
/// any before it. Use one for each thread.
struct PenetrationSpace {
    static constexpr std::size_t first_faces = 256;

    /// A query stops when it has made this many faces (some 100 bytes each). Shallow pairs make some dozen.
    /// Two concentric spheres, with a surface that is about equally deep everywhere, make 4000 with 386
    /// vertices each and 13000 with 1538.
    std::size_t face_limit = 65536;

    epa::Polytope polytope;
    std::vector<epa::Corner> corners;  ///< of the polytope's points

    PenetrationSpace() {
        polytope.reserve(first_faces);
        corners.reserve(first_faces);
    }
};

/// Depth of a difference, from one to four of its corners.
[[nodiscard]] Penetration penetration(const epa::Difference& difference, std::span<const epa::Corner> start,
                                      PenetrationSpace& space);

/// Depth of two bodies that GJK found touching or overlapping; `start` is the state that the query left (any
/// other, or an empty one, costs only steps). `a_from_b` takes B's points into A's frame.
template <SupportTable TableA, SupportTable TableB>
[[nodiscard]] Penetration penetration(const TableA& a, const TableB& b, const Transform<double>& a_from_b,
                                      const SimplexPair<TableA, TableB>& start, PenetrationSpace& space) {
    if (!is_answerable(a, b, a_from_b)) return {};
    const auto transform = cast<ComputeOf<TableA>>(a_from_b);
    const epa::DifferenceOf<TableA, TableB> difference(a, b, transform);
    std::array<epa::Corner, 4> corners{difference.corner(a.first_vertex(), b.first_vertex())};
    const std::uint32_t count = start.belongs_to(a, b) ? start.count() : 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto [v, w] = start.corner(i);
        corners[i] = difference.corner(v, w);
    }
    return penetration(difference, std::span(corners).first(count == 0 ? 1 : count), space);
}

}  // namespace edgewise
