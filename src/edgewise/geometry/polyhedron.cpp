// SPDX-License-Identifier: MIT
//
// Size and volume of a body. The volume is the sum of signed tetrahedra over a fan of each face, seen from
// the first vertex, so that it costs no digits far from the origin; in sums of two doubles, because those of
// a needle cancel.
#include "edgewise/geometry/polyhedron.hpp"

#include "edgewise/geometry/aabb.hpp"
#include "edgewise/geometry/double_double.hpp"

namespace edgewise {

double extent(std::span<const Vec3d> points) { return norm(box_of(points).sides()); }

double volume(const Polyhedron& body) {
    if (body.vertices.empty()) return 0;
    const Vec3d& origin = body.vertices.front();
    DoubleDouble six_volumes;
    for (Index f = 0; f < body.face_count(); ++f) {
        const std::span<const HalfEdge> ring = body.ring_of_face(f);
        const DoubleDoubleVec first = exact_difference(body.vertices[body.tail(ring[0])], origin, 1);
        for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
            const DoubleDoubleVec second = exact_difference(body.vertices[body.tail(ring[k])], origin, 1);
            const DoubleDoubleVec third = exact_difference(body.vertices[body.head(ring[k])], origin, 1);
            six_volumes = six_volumes + dot(first, cross(second, third));
        }
    }
    return six_volumes.value() / 6;
}

}  // namespace edgewise
