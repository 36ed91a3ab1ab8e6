// SPDX-License-Identifier: MIT
//
// Box3D's GJK, started from the simplex that it caches. It asks for the pose of B in A's frame, which its own
// function gives within the query. Its cache names vertices by 8 bits: larger bodies start cold.
#include <box3d/collision.h>

#include <Eigen/Geometry>
#include <vector>

#include "edgewise/peers/adapters/module.hpp"

namespace edgewise::peers {

namespace {

struct Box3d {
    static constexpr const char* name = "box3d";
    static constexpr const char* precision = "f32";
    static constexpr const char* summary = "b3ShapeDistance on points, radius 0";
    static constexpr const char* cache = "the last simplex; nothing beyond 256 vertices";
    static constexpr bool verdict_only = false;

    struct Shape {
        explicit Shape(const Polyhedron& body) {
            points.reserve(body.vertices.size());
            for (const Vec3d& v : body.vertices) points.push_back(to_box3d(v));
        }
        [[nodiscard]] b3ShapeProxy proxy() const {
            return {points.data(), static_cast<int>(points.size()), 0};
        }
        std::vector<b3Vec3> points;
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
    };

    static b3Vec3 to_box3d(const Vec3d& v) {
        return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
    }

    static Vec3d to_world(const Placed& at, b3Vec3 point) {
        const b3Pos world = b3TransformWorldPoint(at.transform, point);
        return {world.x, world.y, world.z};
    }

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b,
                            Cache& cache) {
        constexpr std::size_t named_by_cache = 256;
        if (a.points.size() > named_by_cache || b.points.size() > named_by_cache) cache = {};
        b3DistanceInput input;
        input.proxyA = a.proxy();
        input.proxyB = b.proxy();
        input.transform = b3InvMulWorldTransforms(at_a.transform, at_b.transform);
        input.useRadii = false;
        const b3DistanceOutput found = b3ShapeDistance(&input, &cache.simplex, nullptr, 0);
        PeerAnswer answer;
        answer.separated = found.distance > 0;
        if (!answer.separated) return answer;
        answer.distance = found.distance;
        answer.point_a = to_world(at_a, found.pointA);
        answer.point_b = to_world(at_a, found.pointB);
        return answer;
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<Box3d>; }

}  // namespace edgewise::peers
