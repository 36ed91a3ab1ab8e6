// SPDX-License-Identifier: MIT
//
// PhysX's GJK for shapes of the user's, here a linear scan without margin. Its convex meshes keep no such
// query of their own: their distances are found within contacts, and these alone start warm. Of bodies in
// contact it computes the depth too, which cannot be turned off. It stops at a gap of 2.25e-4 of a distance.
#include <geometry/PxGjkQuery.h>

#include <Eigen/Geometry>
#include <cfloat>
#include <vector>

#include "edgewise/peers/adapters/module.hpp"

namespace edgewise::peers {

namespace {

struct PhysX {
    static constexpr const char* name = "physx";
    static constexpr const char* precision = "f32";
    static constexpr const char* summary =
        "PxGjkQuery::proximityInfo with a linear scan for support, margin 0; of bodies in contact the depth too";
    static constexpr const char* cache = "nothing";

    struct Shape final : physx::PxGjkQuery::Support {
        explicit Shape(const Polyhedron& body) {
            vertices.reserve(body.vertices.size());
            for (const Vec3d& v : body.vertices) vertices.push_back(to_physx(v));
        }
        [[nodiscard]] physx::PxReal getMargin() const override { return 0; }
        [[nodiscard]] physx::PxVec3 supportLocal(const physx::PxVec3& direction) const override {
            const physx::PxVec3* best = vertices.data();
            float most = best->dot(direction);
            for (const physx::PxVec3& v : vertices) {
                const float height = v.dot(direction);
                if (height > most) {
                    most = height;
                    best = &v;
                }
            }
            return *best;
        }
        std::vector<physx::PxVec3> vertices;
    };
    struct Placed {
        explicit Placed(const Pose& pose) {
            const Eigen::Quaternionf turn =
                Eigen::Quaterniond(pose.rotation).normalized().template cast<float>();
            transform = physx::PxTransform(to_physx(pose.translation),
                                           physx::PxQuat(turn.x(), turn.y(), turn.z(), turn.w()));
        }
        physx::PxTransform transform;
    };
    struct Cache {};

    static physx::PxVec3 to_physx(const Vec3d& v) {
        return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
    }
    static Vec3d from_physx(const physx::PxVec3& v) { return {v.x, v.y, v.z}; }

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b, Cache&,
                            bool) {
        constexpr float any_distance = FLT_MAX, unit_length = 1;
        physx::PxVec3 point_a, point_b, axis;
        float separation = 0;
        PeerAnswer answer;
        answer.answered = physx::PxGjkQuery::proximityInfo(a, b, at_a.transform, at_b.transform, any_distance,
                                                           unit_length, point_a, point_b, axis, separation);
        answer.separated = answer.answered && separation > 0;
        if (!answer.separated) return answer;
        answer.distance = separation;
        answer.point_a = from_physx(point_a);
        answer.point_b = from_physx(point_b);
        return answer;
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<PhysX>; }

}  // namespace edgewise::peers
