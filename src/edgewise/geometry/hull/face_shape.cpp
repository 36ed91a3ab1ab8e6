// SPDX-License-Identifier: MIT
#include "edgewise/geometry/hull/face_shape.hpp"

#include <algorithm>

#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {
namespace {

/// Unit vector along a half-edge; zero when it has no length.
Vec3d direction(const Polyhedron& body, HalfEdge h) {
    const Vec3d along = body.vertices[body.head(h)] - body.vertices[body.tail(h)];
    const double length = norm(along);
    return length > 0 ? Vec3d(along / length) : Vec3d(Vec3d::Zero());
}

}  // namespace

double shape_tolerance(const Polyhedron& body, double planarity) {
    double largest = 0;
    for (const Vec3d& v : body.vertices) largest = std::max(largest, max_abs(v));
    return planarity * extent(body.vertices) + offset_rounding * largest;
}

std::string face_name(const Polyhedron& body, Index f) {
    constexpr std::size_t enough = 8;
    const std::span<const HalfEdge> ring = body.ring_of_face(f);
    std::string name = "face ";
    for (std::size_t k = 0; k < std::min(enough, ring.size()); ++k) {
        name += message(k > 0 ? "-" : "", body.input_index[body.tail(ring[k])]);
    }
    return ring.size() > enough ? name + "-..." : name;
}

std::optional<Index> corner_outside(const Polyhedron& body, Index f, double tolerance) {
    const std::span<const HalfEdge> ring = body.ring_of_face(f);
    for (const HalfEdge h : ring) {
        const Vec3d& tail = body.vertices[body.tail(h)];
        const Vec3d inward = cross(body.face_planes[f].normal, direction(body, h));
        if (max_abs(inward) == 0) return body.tail(h);
        for (const HalfEdge other : ring) {
            const Index corner = body.tail(other);
            if (dot(inward, Vec3d(body.vertices[corner] - tail)) < -tolerance) return corner;
        }
    }
    return std::nullopt;
}

Index most_reflex_corner(const Polyhedron& body, Index f) {
    const std::span<const HalfEdge> ring = body.ring_of_face(f);
    Index worst = body.tail(ring.front());
    double least = 2;  // above every sine
    HalfEdge before = ring.back();
    for (const HalfEdge h : ring) {
        const double turn =
            dot(body.face_planes[f].normal, cross(direction(body, before), direction(body, h)));
        if (turn < least) {
            least = turn;
            worst = body.tail(h);
        }
        before = h;
    }
    return worst;
}

}  // namespace edgewise
