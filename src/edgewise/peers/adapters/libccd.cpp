// SPDX-License-Identifier: MIT
//
// libccd's own query: it reports whether bodies intersect, and no distance. The support function is the
// user's, here a linear scan.
#include <ccd/ccd.h>
#include <ccd/quat.h>

#include <vector>

#include "edgewise/peers/adapters/module.hpp"

namespace edgewise::peers {

namespace {

struct Libccd {
    static constexpr const char* name = "libccd";
    static constexpr const char* precision = sizeof(ccd_real_t) == sizeof(double) ? "f64" : "f32";
    static constexpr const char* summary =
        "ccdGJKIntersect, with a linear scan for support: a verdict, no distance";
    static constexpr const char* cache = "nothing";
    static constexpr bool verdict_only = true;

    struct Shape {
        explicit Shape(const Polyhedron& body) : vertices(body.vertices) {}
        std::vector<Vec3d> vertices;
    };
    using Placed = Pose;
    struct Cache {};

    /// What libccd hands back to the support function.
    struct Body {
        const Shape* shape;
        const Pose* pose;
    };

    static void support(const void* object, const ccd_vec3_t* along, ccd_vec3_t* farthest) {
        const Body& body = *static_cast<const Body*>(object);
        const Vec3d direction =
            multiply_transposed(body.pose->rotation, Vec3d(along->v[0], along->v[1], along->v[2]));
        const Vec3d* best = body.shape->vertices.data();
        double most = dot(*best, direction);
        for (const Vec3d& v : body.shape->vertices) {
            const double height = dot(v, direction);
            if (height > most) {
                most = height;
                best = &v;
            }
        }
        const Vec3d point = body.pose->apply(*best);
        ccdVec3Set(farthest, point.x(), point.y(), point.z());
    }

    static PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b, Cache&,
                            bool) {
        ccd_t settings;
        CCD_INIT(&settings);
        settings.support1 = settings.support2 = support;
        settings.max_iterations = 100;
        const Body body_a{&a, &at_a}, body_b{&b, &at_b};
        return {.separated = ccdGJKIntersect(&body_a, &body_b, &settings) == 0};
    }
};

}  // namespace

extern "C" const PeerInfo* edgewise_peer() { return &info_of<Libccd>; }

}  // namespace edgewise::peers
