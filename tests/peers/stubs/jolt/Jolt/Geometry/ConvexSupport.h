// SPDX-License-Identifier: MIT
//
// Jolt's supports that its adapter uses, written from the calls.
#pragma once

#include <Jolt/Jolt.h>

namespace JPH {

template <class Object>
struct TransformedConvexObject {
    TransformedConvexObject(const Mat44& transform, const Object& object)
        : mTransform(transform), mObject(object) {}
    Vec3 GetSupport(Vec3Arg direction) const {
        return mTransform * mObject.GetSupport(mTransform.Multiply3x3Transposed(direction));
    }
    Mat44 mTransform;
    const Object& mObject;
};

template <class Vertices>
struct PolygonConvexSupport {
    explicit PolygonConvexSupport(const Vertices& vertices) : mVertices(vertices) {}
    Vec3 GetSupport(Vec3Arg direction) const {
        Vec3 best = mVertices[0];
        for (const Vec3& v : mVertices) {
            if (v.Dot(direction) > best.Dot(direction)) best = v;
        }
        return best;
    }
    const Vertices& mVertices;
};

}  // namespace JPH
