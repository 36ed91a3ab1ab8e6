// SPDX-License-Identifier: MIT
//
// The part of PhysX's interface that its adapter uses, written from the calls. The distance is that of the centres of
// the bodies' boxes in their own frames.
#pragma once

#include <cmath>

namespace physx {

using PxReal = float;

struct PxVec3 {
    PxVec3() = default;
    PxVec3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}
    float dot(const PxVec3& v) const { return x * v.x + y * v.y + z * v.z; }
    PxVec3 cross(const PxVec3& v) const { return {y * v.z - z * v.y, z * v.x - x * v.z, x * v.y - y * v.x}; }
    PxVec3 operator+(const PxVec3& v) const { return {x + v.x, y + v.y, z + v.z}; }
    PxVec3 operator-(const PxVec3& v) const { return {x - v.x, y - v.y, z - v.z}; }
    PxVec3 operator*(float f) const { return {x * f, y * f, z * f}; }
    float x, y, z;
};

struct PxQuat {
    PxQuat() = default;
    PxQuat(float x_, float y_, float z_, float w_) : x(x_), y(y_), z(z_), w(w_) {}
    PxVec3 rotate(const PxVec3& v) const {
        const PxVec3 axis(x, y, z), twice = axis.cross(v) * 2;
        return v + twice * w + axis.cross(twice);
    }
    float x, y, z, w;
};

struct PxTransform {
    PxTransform() = default;
    PxTransform(const PxVec3& position, const PxQuat& orientation) : q(orientation), p(position) {}
    PxVec3 transform(const PxVec3& v) const { return q.rotate(v) + p; }
    PxQuat q;
    PxVec3 p;
};

class PxGjkQuery {
  public:
    struct Support {
        virtual ~Support() = default;
        virtual PxReal getMargin() const = 0;
        virtual PxVec3 supportLocal(const PxVec3& direction) const = 0;
    };

    static bool proximityInfo(const Support& a, const Support& b, const PxTransform& at_a,
                              const PxTransform& at_b, PxReal contact_distance, PxReal, PxVec3& point_a,
                              PxVec3& point_b, PxVec3& axis, PxReal& separation) {
        point_a = at_a.transform(centre_of(a));
        point_b = at_b.transform(centre_of(b));
        axis = point_a - point_b;
        separation = std::sqrt(axis.dot(axis)) - a.getMargin() - b.getMargin();
        return separation <= contact_distance && is_farthest(a) && is_farthest(b);
    }

  private:
    static bool is_farthest(const Support& body) {
        return body.supportLocal({1, 0, 0}).x > body.supportLocal({-1, 0, 0}).x;
    }
    static PxVec3 centre_of(const Support& body) {
        const PxVec3 highest(body.supportLocal({1, 0, 0}).x, body.supportLocal({0, 1, 0}).y,
                             body.supportLocal({0, 0, 1}).z);
        const PxVec3 lowest(body.supportLocal({-1, 0, 0}).x, body.supportLocal({0, -1, 0}).y,
                            body.supportLocal({0, 0, -1}).z);
        return (highest + lowest) * 0.5f;
    }
};

}  // namespace physx
