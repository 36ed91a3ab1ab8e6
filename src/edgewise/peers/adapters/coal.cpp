// SPDX-License-Identifier: MIT
//
// Coal's GJK with its default settings and no depth, started from the guess that its solver leaves: a
// direction, and for each body the vertex where its climb for support begins.
#include <coal/narrowphase/narrowphase.h>
#include <coal/shape/convex.h>

#include <limits>
#include <memory>
#include <vector>

#include "edgewise/peers/adapters/module.hpp"

namespace edgewise::peers {

namespace {

/// Faces as fans of triangles.
[[nodiscard]] coal::Convex<coal::Triangle> to_coal(const Polyhedron& body) {
    auto points = std::make_shared<std::vector<coal::Vec3s>>(body.vertices.begin(), body.vertices.end());
    auto triangles = std::make_shared<std::vector<coal::Triangle>>();
    for (std::size_t f = 0; f < body.face_count(); ++f) {
        const auto ring = body.ring_of_face(static_cast<Index>(f));
        for (std::size_t i = 2; i < ring.size(); ++i)
            triangles->emplace_back(body.tail(ring[0]), body.tail(ring[i - 1]), body.tail(ring[i]));
    }
    return {points, static_cast<unsigned>(points->size()), triangles,
            static_cast<unsigned>(triangles->size())};
}

struct Coal {
    static constexpr const char* name = "coal";
    static constexpr const char* precision = "f64";
    static constexpr const char* summary =
        "GJKSolver::shapeDistance on Convex, default tolerance; verdicts with an upper bound of 0";
    static constexpr const char* cache = "the last direction and support vertices";

    struct Shape {
        explicit Shape(const Polyhedron& body) : convex(to_coal(body)) {}
        coal::Convex<coal::Triangle> convex;
    };
    struct Placed {
        explicit Placed(const Pose& pose)
            : transform(coal::Matrix3s(pose.rotation), coal::Vec3s(pose.translation)) {}
        coal::Transform3s transform;
    };
    /// Start of the solver's search, in its state before the first query.
    struct Cache {
        coal::Vec3s direction = coal::Vec3s(1, 0, 0);
        coal::support_func_guess_t vertices = coal::support_func_guess_t::Zero();
    };

    static coal::GJKSolver& solver() {
        static coal::GJKSolver one = [] {
            coal::GJKSolver made;
            made.gjk_initial_guess = coal::GJKInitialGuess::CachedGuess;
            return made;
        }();
        return one;
    }

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b,
                            Cache& cache, bool verdict_alone) {
        using Status = coal::details::GJK::Status;
        coal::GJKSolver& asked = solver();
        asked.distance_upper_bound = verdict_alone ? 0 : std::numeric_limits<double>::max();
        asked.cached_guess = cache.direction;
        asked.support_func_cached_guess = cache.vertices;
        coal::Vec3s point_a, point_b, normal;
        const double distance = asked.shapeDistance(a.convex, at_a.transform, b.convex, at_b.transform, false,
                                                    point_a, point_b, normal);
        cache = {asked.cached_guess, asked.support_func_cached_guess};
        const bool separated = asked.gjk.status == Status::NoCollisionEarlyStopped ||
                               (asked.gjk.status == Status::NoCollision && distance > 0);
        if (verdict_alone || !separated)
            return {.answered = asked.gjk.status != Status::Failed, .separated = separated};
        return {.separated = true, .distance = distance, .point_a = point_a, .point_b = point_b};
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<Coal>; }

}  // namespace edgewise::peers
