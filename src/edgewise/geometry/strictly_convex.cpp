// SPDX-License-Identifier: MIT
#include "edgewise/geometry/strictly_convex.hpp"

#include <algorithm>
#include <cmath>

#include "edgewise/geometry/aabb.hpp"
#include "edgewise/geometry/hull/extreme_frame.hpp"
#include "edgewise/geometry/hull/point_set.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {

namespace {

class Turns {
  public:
    Turns(const Polyhedron& body, double least) : body_(body), least_(least) {
        for (const Vec3d& v : body.vertices) reach_ = std::max(reach_, max_abs(v));
    }

    [[nodiscard]] bool at_every_corner(Index f) const {
        const auto ring = body_.ring_of_face(f);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec3d side = along(ring[i]), next = along(ring[(i + 1) % ring.size()]);
            if (!enough(side, next, std::min(norm(side), norm(next)))) return false;
        }
        return true;
    }

    [[nodiscard]] bool across(const PolyhedronEdge& edge) const {
        return enough(body_.face_planes[edge.left].normal, body_.face_planes[edge.right].normal,
                      norm(Vec3d(body_.vertices[edge.head] - body_.vertices[edge.tail])));
    }

    /// Times the largest coordinate: how far the edge's turn takes one of its length out of the plane.
    [[nodiscard]] bool outwards(const PolyhedronEdge& edge) const {
        const Vec3d side = body_.vertices[edge.head] - body_.vertices[edge.tail];
        const Vec3d turn = cross(body_.face_planes[edge.left].normal, body_.face_planes[edge.right].normal);
        return dot(turn, side) >= least_ * reach_;
    }

    [[nodiscard]] bool is_bent(Index f) const {
        const auto ring = body_.ring_of_face(f);
        return std::any_of(ring.begin(), ring.end(), [&](HalfEdge h) {
            return std::abs(body_.face_planes[f].distance(body_.vertices[body_.tail(h)])) >
                   bent_face * reach_;
        });
    }

  private:
    /// Compares by the sine, which near zero equals the angle; not used for an obtuse turn.
    [[nodiscard]] bool enough(const Vec3d& from, const Vec3d& to, double length) const {
        const double lengths = norm(from) * norm(to);
        const double sine = dot(from, to) <= 0 ? 1 : norm(Vec3d(cross(from, to))) / lengths;
        return sine >= least_ && sine * length >= least_ * reach_;
    }
    [[nodiscard]] Vec3d along(HalfEdge h) const {
        return body_.vertices[body_.head(h)] - body_.vertices[body_.tail(h)];
    }

    const Polyhedron& body_;
    double least_, reach_ = 0;
};

/// Returns true if a ball around the vertices' mean, far wider than a thin solid, lies inside all faces.
bool holds_ball(const Polyhedron& body) {
    Vec3d mean = Vec3d::Zero();
    for (const Vec3d& v : body.vertices) mean += v / static_cast<double>(body.vertex_count());
    const double radius = 0x1p-8 * norm(box_of(body.vertices).sides());
    return std::ranges::all_of(body.face_planes, [&](const auto& p) { return p.distance(mean) < -radius; });
}

/// Returns true for a solid thinner than thin_solid; a polygon is flat, not thin.
bool is_thin(const Polyhedron& body) {
    return body.face_count() > 2 && !holds_ball(body) &&
           extreme_frame(body.vertices, distinct_points(body.vertices)).across_plane < thin_solid;
}

}  // namespace

bool is_strictly_convex(const Polyhedron& body, double least_turn) {
    if (is_thin(body)) return false;
    const Turns turns(body, least_turn);
    for (Index f = 0; f < body.face_count(); ++f) {
        if (!turns.at_every_corner(f) || turns.is_bent(f)) return false;
    }
    return body.face_count() == 0 ||
           std::all_of(body.edges.begin(), body.edges.end(),
                       [&](const PolyhedronEdge& edge) { return turns.across(edge); });
}

bool is_climbable(const Polyhedron& body) {
    const Turns turns(body, climbable_turn);
    for (Index f = 0; f < body.face_count(); ++f) {
        if (turns.is_bent(f)) return false;
    }
    return body.face_count() < 3 ||
           std::all_of(body.edges.begin(), body.edges.end(),
                       [&](const PolyhedronEdge& edge) { return turns.outwards(edge); });
}

}  // namespace edgewise
