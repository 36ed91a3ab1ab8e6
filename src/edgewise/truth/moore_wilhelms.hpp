// SPDX-License-Identifier: MIT
//
// The paper's control: the interpenetration test of Moore and Wilhelms, "Collision Detection and Response for
// Computer Animation" (SIGGRAPH 1988). A vertex, an edge or a face centroid of one body strictly inside the
// other, tested both ways. It answers contact or no contact; the paper counts how often an algorithm
// disagrees.
//
// Departure: an edge is clipped against all planes at once (Cyrus and Beck), and a range that is left means a
// hit; testing the midpoints of its crossings says the same. All tests are strict: bodies that only touch are
// not in contact for it, nor is a body with its exact copy, because even the centroids lie on the surface.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise::truth {

inline constexpr std::size_t fewest_faces_of_a_solid = 4;

[[nodiscard]] inline bool is_inside(const Polyhedron& body, const Vec3d& point) {
    return std::all_of(body.face_planes.begin(), body.face_planes.end(),
                       [&](const Plane<double>& plane) { return plane.distance(point) < 0; });
}

/// Returns true if a part of the open segment lies inside all planes.
[[nodiscard]] inline bool pierces(const Polyhedron& body, const Vec3d& tail, const Vec3d& head) {
    double enter = 0, leave = 1;
    for (const Plane<double>& plane : body.face_planes) {
        const double at_tail = plane.distance(tail), at_head = plane.distance(head);
        if (at_tail >= 0 && at_head >= 0) return false;
        if (at_tail >= 0) enter = std::max(enter, at_tail / (at_tail - at_head));
        if (at_head >= 0) leave = std::min(leave, at_tail / (at_tail - at_head));
    }
    return enter < leave;
}

[[nodiscard]] inline Vec3d centroid(const Polyhedron& body, Index face) {
    Vec3d sum = Vec3d::Zero();
    const auto ring = body.ring_of_face(face);
    for (const auto entry : ring) sum += body.vertices[body.tail(entry)];
    return sum / static_cast<double>(ring.size());
}

/// Returns true if a vertex, an edge or a face centroid of the visitor is inside the host.
[[nodiscard]] inline bool visits(const Polyhedron& host, const Polyhedron& visitor,
                                 const Transform<double>& host_from_visitor) {
    std::vector<Vec3d> points;
    for (const Vec3d& v : visitor.vertices) points.push_back(host_from_visitor.point(v));
    const auto inside = [&](const Vec3d& point) { return is_inside(host, point); };
    if (std::any_of(points.begin(), points.end(), inside)) return true;
    const auto hits = [&](const PolyhedronEdge& edge) {
        return pierces(host, points[edge.tail], points[edge.head]);
    };
    if (std::any_of(visitor.edges.begin(), visitor.edges.end(), hits)) return true;
    for (Index f = 0; f < visitor.face_count(); ++f) {
        if (inside(host_from_visitor.point(centroid(visitor, f)))) return true;
    }
    return false;
}

/// Returns true if the bodies interpenetrate; no value for flat bodies, which have no inside. `a_from_b`
/// takes B's points into A's frame. Tests every vertex, edge and face of one body against every face of the
/// other: a reference, not an algorithm to time.
[[nodiscard]] inline std::optional<bool> moore_wilhelms(const Polyhedron& a, const Polyhedron& b,
                                                        const Transform<double>& a_from_b) {
    if (std::min(a.face_count(), b.face_count()) < fewest_faces_of_a_solid) return std::nullopt;
    return visits(a, b, a_from_b) || visits(b, a, a_from_b.inverse());
}

}  // namespace edgewise::truth
