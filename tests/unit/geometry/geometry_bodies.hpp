// SPDX-License-Identifier: MIT
//
// Point sets for the geometry tests: seeded, without libm's trigonometry, so that every machine tests the
// same bodies.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "edgewise/geometry/check_polyhedron.hpp"
#include "edgewise/geometry/hull.hpp"

namespace edgewise::testing {

using Points = std::vector<Vec3d>;
using Faces = std::vector<std::vector<Index>>;

/// Uniform numbers from the top bits of a generator with a sequence that the standard fixes.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : bits_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
    }
    std::size_t below(std::size_t bound) { return bits_() % bound; }
    Vec3d vector() {
        const double x = between(-1, 1);
        const double y = between(-1, 1);
        return {x, y, between(-1, 1)};
    }
    Vec3d direction() {
        for (;;) {
            const Vec3d v = vector();
            const double length = norm(v);
            if (length > 0.1 && length <= 1) return v / length;
        }
    }

  private:
    std::mt19937_64 bits_;
};

/// Returns a rotation from a random quaternion; orthogonal to rounding.
inline Mat3d random_rotation(Dice& dice) {
    const Vec3d axis = dice.direction();
    const double w = dice.between(-1, 1);
    const double n = std::sqrt(w * w + 1);
    const double s = w / n;
    const double x = axis.x() / n;
    const double y = axis.y() / n;
    const double z = axis.z() / n;
    Mat3d r;
    r << 1 - 2 * (y * y + z * z), 2 * (x * y - s * z), 2 * (x * z + s * y),  //
        2 * (x * y + s * z), 1 - 2 * (x * x + z * z), 2 * (y * z - s * x),   //
        2 * (x * z - s * y), 2 * (y * z + s * x), 1 - 2 * (x * x + y * y);
    return r;
}

/// Corner i has x from bit 0, y from bit 1, z from bit 2.
inline Points box_points(const Vec3d& half) {
    Points points;
    for (int i = 0; i < 8; ++i) {
        points.push_back(Vec3d((i & 1) ? half.x() : -half.x(), (i & 2) ? half.y() : -half.y(),
                               (i & 4) ? half.z() : -half.z()));
    }
    return points;
}

/// The faces of box_points, counter-clockwise from outside.
inline Faces box_faces() {
    return {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
}

/// Corners, edge middles, face middles and interior of a box.
inline Points grid_points(int steps, const Vec3d& half) {
    Points points;
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; j <= steps; ++j) {
            for (int k = 0; k <= steps; ++k) {
                const Vec3d p(2.0 * i / steps - 1, 2.0 * j / steps - 1, 2.0 * k / steps - 1);
                points.push_back(p.cwiseProduct(half));
            }
        }
    }
    return points;
}

inline Points sphere_points(Dice& dice, std::size_t count, const Vec3d& radii) {
    Points points;
    while (points.size() < count) points.push_back(dice.direction().cwiseProduct(radii));
    return points;
}

inline Points placed(const Points& points, const Mat3d& rotation, const Vec3d& shift, double scale) {
    Points result;
    for (const Vec3d& p : points) result.push_back((multiply(rotation, p) + shift) * scale);
    return result;
}

inline std::string all_violations(const Polyhedron& body) {
    std::string lines;
    for (const std::string& line : check_polyhedron(body)) lines += line + "\n";
    return lines;
}

}  // namespace edgewise::testing
