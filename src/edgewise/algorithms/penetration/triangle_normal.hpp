// SPDX-License-Identifier: MIT
//
// The unit normal of a triangle, accurate to a few rounding steps even for a sliver: there the cross product
// of plain differences is noise. Parallel edges of both bodies make three corners that are collinear except
// for the last digit. Sometimes they are so nearly collinear that a product in double the digits is noise
// too; hence the exact product.
#pragma once

#include <cassert>

#include "edgewise/algorithms/penetration/expansion.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::epa {

/// Exact cross product, rounded at the end; zero only if the corners lie on a line.
[[nodiscard]] [[gnu::noinline]] inline Vec3d exact_cross(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const DoubleDoubleVec p = exact_difference(b, a, 1), q = exact_difference(c, a, 1);
    const auto minor = [](const DoubleDouble& p1, const DoubleDouble& q2, const DoubleDouble& p2,
                          const DoubleDouble& q1) {
        Expansion sum;
        sum.add_product(p1, q2);
        sum.add_product(-p2, q1);
        return sum.value();
    };
    return {minor(p.y(), q.z(), p.z(), q.y()), minor(p.z(), q.x(), p.x(), q.z()),
            minor(p.x(), q.y(), p.y(), q.x())};
}

/// Unit normal, for corners that are not on a line.
[[nodiscard]] inline Vec3d triangle_normal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const Vec3d p = b - a, q = c - a;
    Vec3d normal = cross(p, q);
    if (squared_norm(normal) < Tolerance<double>::fair_corner * squared_norm(p) * squared_norm(q)) {
        normal = exact_cross(a, b, c);
        assert(max_abs(normal) > 0 && "three corners on a line have no normal");
        normal /= max_abs(normal);  // its square may vanish
    }
    return normal / norm(normal);
}

}  // namespace edgewise::epa
