// SPDX-License-Identifier: MIT
//
// Unit quaternions: how scenes keep an orientation. A product of many small turns stays a rotation, because
// four numbers are scaled back to length one with a single square root; nine matrix entries would drift
// apart.
//
// Sums are spelled out, never Eigen's: the same bits on every machine.
#pragma once

#include <cmath>

#include "edgewise/geometry/vec.hpp"

namespace edgewise::scene {

using edgewise::squared_norm;

/// w + x i + y j + z k.
struct Quaternion {
    double w = 1, x = 0, y = 0, z = 0;
};

[[nodiscard]] inline double squared_norm(const Quaternion& q) {
    return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}

[[nodiscard]] inline Quaternion normalised(const Quaternion& q) {
    const double length = std::sqrt(squared_norm(q));
    return {q.w / length, q.x / length, q.y / length, q.z / length};
}

/// First b, then a.
[[nodiscard]] inline Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// The rotation of a unit quaternion; orthogonal to a few rounding steps.
[[nodiscard]] inline Mat3d rotation_matrix(const Quaternion& q) {
    Mat3d r;
    r.row(0) << 1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.w * q.z), 2 * (q.x * q.z + q.w * q.y);
    r.row(1) << 2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z - q.w * q.x);
    r.row(2) << 2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y);
    return r;
}

}  // namespace edgewise::scene
