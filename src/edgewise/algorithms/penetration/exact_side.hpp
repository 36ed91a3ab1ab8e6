// SPDX-License-Identifier: MIT
//
// The side of a triangle's plane on which a point lies, without error: a filter in floating point, and in
// doubtful cases the sum of all the terms of the determinant, kept exactly.
//
// Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997;
// without the stages between his filter and the full sum, since few points are in doubt.
#pragma once

#include <cmath>

#include "edgewise/algorithms/penetration/expansion.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::epa {

[[nodiscard]] [[gnu::noinline]] inline int exact_side(const Vec3d& a, const Vec3d& b, const Vec3d& c,
                                                      const Vec3d& point) {
    const DoubleDoubleVec p = exact_difference(b, a, 1), q = exact_difference(c, a, 1);
    const DoubleDoubleVec r = exact_difference(point, a, 1);
    Expansion determinant;
    determinant.add_product(r.x(), p.y(), q.z());
    determinant.add_product(-r.x(), p.z(), q.y());
    determinant.add_product(r.y(), p.z(), q.x());
    determinant.add_product(-r.y(), p.x(), q.z());
    determinant.add_product(r.z(), p.x(), q.y());
    determinant.add_product(-r.z(), p.y(), q.x());
    return determinant.sign();
}

/// Returns 1 if the point is above the triangle (from there its corners run counter-clockwise), -1 if below,
/// 0 in its plane.
[[nodiscard]] inline int side(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& point) {
    const Vec3d p = b - a, q = c - a, r = point - a;
    const double yz = p.y() * q.z(), zy = p.z() * q.y();
    const double zx = p.z() * q.x(), xz = p.x() * q.z();
    const double xy = p.x() * q.y(), yx = p.y() * q.x();
    const double volume = r.x() * (yz - zy) + r.y() * (zx - xz) + r.z() * (xy - yx);
    const double permanent = std::abs(r.x()) * (std::abs(yz) + std::abs(zy)) +
                             std::abs(r.y()) * (std::abs(zx) + std::abs(xz)) +
                             std::abs(r.z()) * (std::abs(xy) + std::abs(yx));
    const double noise = Tolerance<double>::volume_noise * permanent;
    if (volume > noise) return 1;
    if (volume < -noise) return -1;
    return exact_side(a, b, c, point);
}

}  // namespace edgewise::epa
