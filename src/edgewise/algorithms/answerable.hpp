// SPDX-License-Identifier: MIT
//
// Whether a query of this relative pose can be answered at all: the one look at what a caller hands over. A
// pose that is not finite, no rotation, or so long that its square overflows would be answered with a
// distance that is no number, or with a contact that is none; such a query fails (Status::failed) and leaves
// its pair as it was. Fifty operations, no division and no branch but the last.
#pragma once

#include <cmath>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {

/// By the squares of all entries of R^T R - I, which is no number where an entry of R is none. Scalar: what
/// computes the query.
template <class Scalar>
[[nodiscard]] bool is_answerable(const Transform<double>& a_from_b) {
    const Vec3d x = a_from_b.rotation.col(0), y = a_from_b.rotation.col(1), z = a_from_b.rotation.col(2);
    const double xx = dot(x, x) - 1, yy = dot(y, y) - 1, zz = dot(z, z) - 1;
    const double xy = dot(x, y), yz = dot(y, z), zx = dot(z, x);
    const double squares = xx * xx + yy * yy + zz * zz + 2 * (xy * xy + yz * yz + zx * zx);
    const Vec3d& t = a_from_b.translation;
    const double offset = std::abs(t.x()) + std::abs(t.y()) + std::abs(t.z());
    return squares <= sloppiest_rotation * sloppiest_rotation &&
           offset <= static_cast<double>(Tolerance<Scalar>::largest_offset);
}

}  // namespace edgewise
