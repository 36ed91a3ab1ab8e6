// SPDX-License-Identifier: MIT
//
// An oriented plane <normal, p> + offset = 0; positive on the side the normal points to.
#pragma once

#include "edgewise/geometry/vec.hpp"

namespace edgewise {

template <class Scalar>
struct Plane {
    Vec3<Scalar> normal;
    Scalar offset;

    /// Signed distance, in units of |normal|.
    [[nodiscard]] Scalar distance(const Vec3<Scalar>& p) const { return dot(normal, p) + offset; }
};

template <class To, class From>
[[nodiscard]] Plane<To> cast(const Plane<From>& p) {
    return {cast<To>(p.normal), static_cast<To>(p.offset)};
}

}  // namespace edgewise
