// SPDX-License-Identifier: MIT
//
// Jolt's GJK on its own linear scan for support, in A's frame and with the guess that its collision code
// starts from: the line of the centres. A warm query starts along the last axis. All of it is in headers.
#include <Jolt/Jolt.h>  // before all others of its headers

#include <Jolt/Geometry/ConvexSupport.h>
#include <Jolt/Geometry/GJKClosestPoint.h>

#include <cfloat>
#include <cmath>
#include <vector>

#include "edgewise/peers/adapters/module.hpp"

namespace edgewise::peers {

namespace {

struct Jolt {
    static constexpr const char* name = "jolt";
    static constexpr const char* precision = "f32";
    static constexpr const char* summary =
        "GJKClosestPoint::GetClosestPoints on PolygonConvexSupport, tolerance 0; verdicts by Intersects";
    static constexpr const char* cache = "the last axis";

    using Vertices = std::vector<JPH::Vec3>;
    struct Shape {
        explicit Shape(const Polyhedron& body) {
            vertices.reserve(body.vertices.size());
            for (const Vec3d& v : body.vertices) vertices.push_back(to_jolt(v));
        }
        Vertices vertices;
    };
    struct Placed {
        explicit Placed(const Pose& pose) {
            const auto column = [&](int i) { return JPH::Vec4(to_jolt(pose.rotation.col(i)), 0); };
            transform = JPH::Mat44(column(0), column(1), column(2), to_jolt(pose.translation));
        }
        JPH::Mat44 transform;
    };
    struct Cache {
        JPH::Vec3 axis;
        bool is_warm = false;
    };

    static JPH::Vec3 to_jolt(const Vec3d& v) {
        return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
    }
    static Vec3d from_jolt(JPH::Vec3Arg v) { return {v.GetX(), v.GetY(), v.GetZ()}; }

    /// Never zero, which Jolt cannot start from.
    static JPH::Vec3 first_axis(const JPH::Mat44& a_from_b) {
        const JPH::Vec3 axis = a_from_b.GetTranslation();
        return axis.IsNearZero() ? JPH::Vec3(1, 0, 0) : axis;
    }

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b,
                            Cache& cache, bool verdict_alone) {
        const JPH::Mat44 a_from_b = at_a.transform.InversedRotationTranslation() * at_b.transform;
        const JPH::PolygonConvexSupport<Vertices> body_a(a.vertices), body_b(b.vertices);
        const JPH::TransformedConvexObject<JPH::PolygonConvexSupport<Vertices>> placed_b(a_from_b, body_b);
        JPH::Vec3 axis = cache.is_warm ? cache.axis : first_axis(a_from_b);
        JPH::Vec3 point_a, point_b;
        JPH::GJKClosestPoint gjk;
        const float squared =
            verdict_alone ? static_cast<float>(!gjk.Intersects(body_a, placed_b, 0.0f, axis))
                          : gjk.GetClosestPoints(body_a, placed_b, 0.0f, FLT_MAX, axis, point_a, point_b);
        PeerAnswer answer;
        answer.separated = squared > 0;
        cache = {axis, answer.separated};
        if (verdict_alone || !answer.separated) return answer;
        answer.distance = std::sqrt(squared);
        answer.point_a = from_jolt(at_a.transform * point_a);
        answer.point_b = from_jolt(at_a.transform * point_b);
        return answer;
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<Jolt>; }

}  // namespace edgewise::peers
