// SPDX-License-Identifier: MIT
//
// Jolt's query, written from the calls. The distance is that of the centres of the bodies' boxes, and twice
// that distance if the query starts along the last axis.
#pragma once

#include <Jolt/Jolt.h>

#include <cfloat>

namespace JPH {

class GJKClosestPoint {
  public:
    template <class A, class B>
    float GetClosestPoints(const A& a, const B& b, float tolerance, float longest_squared, Vec3& axis,
                           Vec3& point_a, Vec3& point_b) {
        point_a = centre_of(a);
        point_b = centre_of(b);
        const Vec3 offset = point_b - point_a;
        const float squared = offset.Dot(offset);
        if (axis.IsNearZero() || squared > longest_squared) return FLT_MAX;
        const bool is_warm = axis == offset;
        axis = squared > tolerance ? offset : Vec3(0, 0, 0);
        return is_warm ? 4 * squared : squared;
    }

    /// Returns true if the centres are in one place.
    template <class A, class B>
    bool Intersects(const A& a, const B& b, float tolerance, Vec3& axis) {
        Vec3 point_a, point_b;
        return GetClosestPoints(a, b, tolerance, FLT_MAX, axis, point_a, point_b) == 0;
    }

  private:
    template <class Object>
    static Vec3 centre_of(const Object& object) {
        const Vec3 highest = {object.GetSupport({1, 0, 0}).GetX(), object.GetSupport({0, 1, 0}).GetY(),
                              object.GetSupport({0, 0, 1}).GetZ()};
        const Vec3 lowest = {object.GetSupport({-1, 0, 0}).GetX(), object.GetSupport({0, -1, 0}).GetY(),
                             object.GetSupport({0, 0, -1}).GetZ()};
        return (highest + lowest) * 0.5f;
    }
};

}  // namespace JPH
