// SPDX-License-Identifier: MIT
//
// Box3D's GJK, started from the simplex that it caches, and for verdicts alone its collision of hulls,
// started from the separating axis that it caches, as far as it takes bodies: no more than 128 edges. Both
// ask for the pose of B in A's frame, which its own function gives within the query. The simplex names
// vertices by 8 bits: larger bodies start cold.
#include <box3d/collision.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "edgewise/peers/adapters/module.hpp"

namespace edgewise::peers {

namespace {

struct Box3d {
    static constexpr const char* name = "box3d";
    static constexpr const char* precision = "f32";
    static constexpr const char* summary = "b3ShapeDistance on points, radius 0; verdicts by b3CollideHulls";
    static constexpr const char* cache = "the last simplex or separating axis; nothing beyond 256 vertices";

    struct Shape {
        explicit Shape(const Polyhedron& body) {
            points.reserve(body.vertices.size());
            for (const Vec3d& v : body.vertices) points.push_back(to_box3d(v));
        }
        [[nodiscard]] b3ShapeProxy proxy() const {
            return {points.data(), static_cast<int>(points.size()), 0};
        }
        /// Made for the first verdict, since distances need none; null if it is too large.
        [[nodiscard]] const b3HullData* hull() const {
            constexpr std::size_t most_vertices = 128;
            const auto count = static_cast<int>(points.size());
            if (!hull_) {
                const bool fits = points.size() <= most_vertices;
                hull_.emplace(fits ? b3CreateHull(points.data(), count, count) : nullptr, b3DestroyHull);
            }
            return hull_->get();
        }
        std::vector<b3Vec3> points;

      private:
        using Hull = std::unique_ptr<b3HullData, decltype(&b3DestroyHull)>;
        mutable std::optional<Hull> hull_;
    };
    struct Placed {
        explicit Placed(const Pose& pose) {
            const Eigen::Quaterniond turn = Eigen::Quaterniond(pose.rotation).normalized();
            transform.q = {to_box3d(turn.vec()), static_cast<float>(turn.w())};
            transform.p = b3ToPos(to_box3d(pose.translation));
        }
        b3WorldTransform transform;
    };
    struct Cache {
        b3SimplexCache simplex{};
        b3SATCache axis{};
    };

    static b3Vec3 to_box3d(const Vec3d& v) {
        return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
    }

    static Vec3d to_world(const Placed& at, b3Vec3 point) {
        const b3Pos world = b3TransformWorldPoint(at.transform, point);
        return {world.x, world.y, world.z};
    }

    /// Points of contact come at gaps up to a tolerance too.
    static bool collide(const b3HullData& a, const b3HullData& b, const b3Transform& a_from_b,
                        b3SATCache& cache) {
        std::array<b3LocalManifoldPoint, 32> points;  // the number that its solver takes
        b3LocalManifold contact{};
        contact.points = points.data();
        b3CollideHulls(&contact, points.size(), &a, &b, a_from_b, &cache);
        return std::any_of(points.data(), points.data() + contact.pointCount,
                           [](const b3LocalManifoldPoint& point) { return point.separation <= 0; });
    }

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b,
                            Cache& cache, bool verdict_alone) {
        constexpr std::size_t named_by_cache = 256;
        if (a.points.size() > named_by_cache || b.points.size() > named_by_cache) cache = {};
        b3DistanceInput input;
        input.proxyA = a.proxy();
        input.proxyB = b.proxy();
        input.transform = b3InvMulWorldTransforms(at_a.transform, at_b.transform);
        input.useRadii = false;
        if (verdict_alone && a.hull() && b.hull())
            return {.separated = !collide(*a.hull(), *b.hull(), input.transform, cache.axis)};
        const b3DistanceOutput found = b3ShapeDistance(&input, &cache.simplex, nullptr, 0);
        if (!(found.distance > 0)) return {};
        return {.separated = true,
                .distance = found.distance,
                .point_a = to_world(at_a, found.pointA),
                .point_b = to_world(at_a, found.pointB)};
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<Box3d>; }

}  // namespace edgewise::peers
