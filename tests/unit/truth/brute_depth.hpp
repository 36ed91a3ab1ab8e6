// SPDX-License-Identifier: MIT
//
// Penetration depth by brute force, for small bodies: the faces of A - B are normal to a face of A, to a face
// of B, or to an edge of each, and the depth is the least support value over all these directions. Also
// tables that hold a body in any precision.
#pragma once

#include <limits>
#include <vector>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/table/canonical.hpp"

namespace edgewise::testing {

/// B's vertices in A's frame.
[[nodiscard]] inline std::vector<Vec3d> moved(const Polyhedron& body, const Transform<double>& pose) {
    std::vector<Vec3d> points;
    for (const Vec3d& v : body.vertices) points.push_back(pose.point(v));
    return points;
}

/// The difference of two bodies, as two sets of points.
struct PointPair {
    std::vector<Vec3d> a, b;

    /// Support value of A - B.
    [[nodiscard]] double reach(const Vec3d& normal) const {
        double far_a = -std::numeric_limits<double>::infinity(), near_b = -far_a;
        for (const Vec3d& p : a) far_a = std::max(far_a, dot(normal, p));
        for (const Vec3d& p : b) near_b = std::min(near_b, dot(normal, p));
        return far_a - near_b;
    }
};

enum class FaceOf { a, b, edges };  ///< what a face of A - B is made of

/// Hands out every direction that a face of A - B can have (and many more), and what it is made of.
template <class Visit>
void for_each_face_direction(const Polyhedron& a, const Polyhedron& b, const Transform<double>& a_from_b,
                             Visit visit) {
    const std::vector<Vec3d> moved_b = moved(b, a_from_b);
    for (const auto& plane : a.face_planes) visit(plane.normal, FaceOf::a);
    for (const auto& plane : b.face_planes) visit(-a_from_b.direction(plane.normal), FaceOf::b);
    for (const auto& e : a.edges) {
        const Vec3d along_a = a.vertices[e.head] - a.vertices[e.tail];
        for (const auto& f : b.edges) {
            const Vec3d along_b = moved_b[f.head] - moved_b[f.tail];
            const Vec3d normal = cross(along_a, along_b);
            const double length = norm(normal);
            if (length < 1e-9 * norm(along_a) * norm(along_b)) continue;  // parallel: a face has that normal
            visit(normal / length, FaceOf::edges);
            visit(-normal / length, FaceOf::edges);
        }
    }
}

struct BruteDepth {
    double depth = std::numeric_limits<double>::infinity();
    FaceOf face = FaceOf::a;
};

[[nodiscard]] inline BruteDepth brute_depth(const Polyhedron& a, const Polyhedron& b,
                                            const Transform<double>& a_from_b) {
    const PointPair points{a.vertices, moved(b, a_from_b)};
    BruteDepth best;
    for_each_face_direction(a, b, a_from_b, [&](const Vec3d& normal, FaceOf face) {
        const double reach = points.reach(normal);
        if (reach < best.depth) best = {reach, face};
    });
    return best;
}

/// How far B can go along a direction before it leaves A.
[[nodiscard]] inline double brute_exit(const Polyhedron& a, const Polyhedron& b,
                                       const Transform<double>& a_from_b, const Vec3d& direction) {
    const PointPair points{a.vertices, moved(b, a_from_b)};
    double exit = std::numeric_limits<double>::infinity();
    for_each_face_direction(a, b, a_from_b, [&](const Vec3d& normal, FaceOf) {
        const double along = dot(normal, direction);
        if (along > 0) exit = std::min(exit, points.reach(normal) / along);
    });
    return exit;
}

/// A body's vertices in any precision.
template <Precision P>
class RoundedTable : public Canonical {
  public:
    using PrecisionType = P;
    using Compute = typename P::Compute;

    explicit RoundedTable(const Polyhedron& body) : Canonical(body) {}

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(cast<typename P::Stored>(Canonical::vertex(v)));
    }
};

static_assert(SupportTable<RoundedTable<f32>>);

/// How far a point lies outside a body; not positive within.
[[nodiscard]] inline double how_far_outside(const Polyhedron& body, const Vec3d& point) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const auto& plane : body.face_planes) farthest = std::max(farthest, plane.distance(point));
    return farthest;
}

}  // namespace edgewise::testing
