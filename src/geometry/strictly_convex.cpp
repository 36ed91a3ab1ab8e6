// SPDX-License-Identifier: MIT
#include "edgewise/geometry/strictly_convex.hpp"

#include <algorithm>

namespace edgewise {

namespace {

/// By the sine, which near zero is the angle; an acute turn is known by its cosine.
bool turns(const Vec3d& from, const Vec3d& to, double least) {
    const double lengths = norm(from) * norm(to);
    return dot(from, to) <= 0 || norm(Vec3d(cross(from, to))) >= least * lengths;
}

bool face_turns_at_every_corner(const Polyhedron& body, Index f, double least) {
    const auto ring = body.ring_of_face(f);
    const auto along = [&](HalfEdge h) {
        return Vec3d(body.vertices[body.head(h)] - body.vertices[body.tail(h)]);
    };
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (!turns(along(ring[i]), along(ring[(i + 1) % ring.size()]), least)) return false;
    }
    return true;
}

}  // namespace

bool is_strictly_convex(const Polyhedron& body, double least_turn) {
    for (Index f = 0; f < body.face_count(); ++f) {
        if (!face_turns_at_every_corner(body, f, least_turn)) return false;
    }
    return body.face_count() == 0 ||
           std::all_of(body.edges.begin(), body.edges.end(), [&](const PolyhedronEdge& edge) {
               return turns(body.face_planes[edge.left].normal, body.face_planes[edge.right].normal,
                            least_turn);
           });
}

}  // namespace edgewise
