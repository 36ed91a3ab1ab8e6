// SPDX-License-Identifier: MIT
//
// What Bullet's two queries share: its shape and its pose. Debian has Bullet in both precisions; its headers
// have the one that BT_USE_DOUBLE_PRECISION says.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <LinearMath/btTransform.h>

#include "edgewise/peers/adapters/module.hpp"

namespace edgewise::peers {

#ifdef BT_USE_DOUBLE_PRECISION
inline constexpr const char* bullet_precision = "f64";
#else
inline constexpr const char* bullet_precision = "f32";
#endif

[[nodiscard]] inline btVector3 to_bullet(const Vec3d& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

[[nodiscard]] inline Vec3d from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// The hull of the vertices, without the margin that Bullet adds by default.
struct BulletShape {
    explicit BulletShape(const Polyhedron& body) {
        for (const Vec3d& v : body.vertices) hull.addPoint(to_bullet(v), false);
        hull.setMargin(0);
        hull.recalcLocalAabb();
    }
    btConvexHullShape hull;
};

struct BulletPlaced {
    explicit BulletPlaced(const Pose& pose) {
        const Mat3d& r = pose.rotation;
        const auto at = [&](int row, int column) { return static_cast<btScalar>(r(row, column)); };
        transform.setBasis(btMatrix3x3(at(0, 0), at(0, 1), at(0, 2), at(1, 0), at(1, 1), at(1, 2), at(2, 0),
                                       at(2, 1), at(2, 2)));
        transform.setOrigin(to_bullet(pose.translation));
    }
    btTransform transform;
};

}  // namespace edgewise::peers
