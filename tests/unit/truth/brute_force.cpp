// SPDX-License-Identifier: MIT
#include "brute_force.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace edgewise::truth {

namespace {

struct WorldBody {
    const Polyhedron& body;
    std::vector<Vec3d> vertices;
    std::vector<Vec3d> normals;  ///< of the faces as placed, not unit

    WorldBody(const Polyhedron& given, const Pose& pose) : body(given) {
        for (const Vec3d& v : body.vertices) vertices.push_back(pose.apply(v));
        for (Index f = 0; f < body.face_count(); ++f) normals.push_back(ring_normal(f));
    }

    [[nodiscard]] Vec3d edge(Index e) const {
        return vertices[body.edges[e].head] - vertices[body.edges[e].tail];
    }

    /// Sum over a fan: twice the area vector, stable also for rings with collinear corners.
    [[nodiscard]] Vec3d ring_normal(Index f) const {
        const auto ring = body.ring_of_face(f);
        const Vec3d& corner = vertices[body.tail(ring[0])];
        Vec3d sum = Vec3d::Zero();
        for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
            sum += cross(Vec3d(vertices[body.tail(ring[i])] - corner),
                         Vec3d(vertices[body.head(ring[i])] - corner));
        }
        return sum;
    }
};

/// Largest product with the direction over the vertices.
double highest(const WorldBody& body, const Vec3d& direction) {
    double best = -std::numeric_limits<double>::infinity();
    for (const Vec3d& v : body.vertices) best = std::max(best, dot(direction, v));
    return best;
}

/// Returns true if B lies beyond A along the direction.
bool separates(const WorldBody& a, const WorldBody& b, const Vec3d& direction) {
    return highest(a, direction) + highest(b, -direction) < 0;
}

bool any_axis_separates(const WorldBody& a, const WorldBody& b) {
    for (const Vec3d& n : a.normals) {
        if (separates(a, b, n)) return true;
    }
    for (const Vec3d& n : b.normals) {
        if (separates(b, a, n)) return true;
    }
    for (Index i = 0; i < a.body.edge_count(); ++i) {
        for (Index j = 0; j < b.body.edge_count(); ++j) {
            const Vec3d n = cross(a.edge(i), b.edge(j));
            if (separates(a, b, n) || separates(a, b, -n)) return true;
        }
    }
    return false;
}

double point_to_segment(const Vec3d& p, const Vec3d& tail, const Vec3d& along) {
    const double t = std::clamp(dot(Vec3d(p - tail), along) / squared_norm(along), 0.0, 1.0);
    return norm(Vec3d(p - tail - t * along));
}

/// Crossing segments by their common normal; else an end of one is nearest.
double segment_to_segment(const WorldBody& a, Index i, const WorldBody& b, Index j) {
    const Vec3d& p = a.vertices[a.body.edges[i].tail];
    const Vec3d& q = b.vertices[b.body.edges[j].tail];
    const Vec3d u = a.edge(i);
    const Vec3d v = b.edge(j);
    double best = std::min({point_to_segment(p, q, v), point_to_segment(p + u, q, v),
                            point_to_segment(q, p, u), point_to_segment(q + v, p, u)});
    const Vec3d n = cross(u, v);
    const double nn = squared_norm(n);
    if (nn == 0) return best;
    const Vec3d r = q - p;
    const double s = dot(cross(r, v), n) / nn;
    const double t = dot(cross(r, u), n) / nn;
    if (s > 0 && s < 1 && t > 0 && t < 1) best = std::min(best, norm(Vec3d(r + t * v - s * u)));
    return best;
}

/// Infinity if the point does not project into the face from outside: then an edge or a vertex is nearer.
double point_to_face(const Vec3d& point, const WorldBody& body, Index f) {
    const Vec3d& n = body.normals[f];
    for (const HalfEdge h : body.body.ring_of_face(f)) {
        const Vec3d& tail = body.vertices[body.body.tail(h)];
        const Vec3d along = body.vertices[body.body.head(h)] - tail;
        if (dot(cross(n, along), Vec3d(point - tail)) < 0) return std::numeric_limits<double>::infinity();
    }
    const Vec3d& corner = body.vertices[body.body.tail(body.body.ring_of_face(f)[0])];
    return std::abs(dot(n, Vec3d(point - corner))) / norm(n);
}

double vertices_to_faces(const WorldBody& a, const WorldBody& b) {
    double best = std::numeric_limits<double>::infinity();
    for (const Vec3d& p : a.vertices) {
        for (Index f = 0; f < b.body.face_count(); ++f) best = std::min(best, point_to_face(p, b, f));
    }
    return best;
}

double edges_to_edges(const WorldBody& a, const WorldBody& b) {
    double best = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < a.body.edge_count(); ++i) {
        for (Index j = 0; j < b.body.edge_count(); ++j) best = std::min(best, segment_to_segment(a, i, b, j));
    }
    return best;
}

}  // namespace

double brute_force_distance(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b,
                            const Pose& pose_b) {
    const WorldBody world_a(a, pose_a);
    const WorldBody world_b(b, pose_b);
    if (!any_axis_separates(world_a, world_b)) return 0;
    return std::min({vertices_to_faces(world_a, world_b), vertices_to_faces(world_b, world_a),
                     edges_to_edges(world_a, world_b)});
}

}  // namespace edgewise::truth
