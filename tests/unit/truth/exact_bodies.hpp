// SPDX-License-Identifier: MIT
//
// Bodies and poses for the tests of the truth room: dyadic boxes, random point sets and rotations.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "edgewise/geometry/pose.hpp"

namespace edgewise::truth {

using Points = std::vector<Vec3d>;

/// Corners of an axis-aligned box.
[[nodiscard]] inline Points box(const Vec3d& low, const Vec3d& high) {
    Points corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                             i & 4 ? high.z() : low.z());
    }
    return corners;
}

inline const Points unit_box = box({0, 0, 0}, {1, 1, 1});

/// Two vertex sets and where they are.
struct PosedPoints {
    Points a, b;
    Pose pose_a, pose_b;

    void scale(double factor) {
        for (Points* points : {&a, &b}) {
            for (Vec3d& v : *points) v *= factor;
        }
        pose_a.translation *= factor;
        pose_b.translation *= factor;
    }
    void shift(const Vec3d& by) {
        pose_a.translation += by;
        pose_b.translation += by;
    }
};

[[nodiscard]] inline Pose moved(const Vec3d& by) {
    Pose pose;
    pose.translation = by;
    return pose;
}

class RandomBodies {
  public:
    explicit RandomBodies(std::uint64_t seed) : bits_(seed) {}

    /// Uniform in [-1, 1).
    [[nodiscard]] double number() { return static_cast<double>(bits_() >> 11) * 0x1p-52 - 1; }

    [[nodiscard]] Vec3d unit() {
        for (;;) {
            const double x = number();
            const double y = number();
            const double z = number();
            const Vec3d v(x, y, z);
            if (norm(v) > 0.1 && norm(v) < 1) return v / norm(v);
        }
    }

    [[nodiscard]] Points on_sphere(int count) {
        Points points;
        for (int i = 0; i < count; ++i) points.push_back(unit());
        return points;
    }

    /// Whole numbers from -2 to 2.
    [[nodiscard]] Vec3d on_grid() {
        const auto digit = [&] { return static_cast<double>(bits_() % 5) - 2; };
        const double x = digit(), y = digit(), z = digit();
        return {x, y, z};
    }

    [[nodiscard]] Points on_grid(std::size_t count) {
        Points points;
        for (std::size_t i = 0; i < count; ++i) points.push_back(on_grid());
        return points;
    }

    /// Returns the rotation of a quaternion with parts (w, u): orthogonal to rounding.
    [[nodiscard]] Mat3d rotation() {
        const Vec3d u = unit();
        const double w = number();
        const double n = w * w + squared_norm(u);
        const double x = u.x(), y = u.y(), z = u.z();
        Mat3d r;
        r << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
            2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
            2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
        return r / n;
    }

    [[nodiscard]] std::mt19937_64& bits() { return bits_; }

  private:
    std::mt19937_64 bits_;
};

}  // namespace edgewise::truth
