// SPDX-License-Identifier: MIT
//
// Rounding to single precision and back, which GCC 12 gets wrong without help: from -O2 on its straight-line
// vectoriser treats double -> float -> double of two neighbours as no operation and drops it. The volatile
// keeps each value scalar; never write the two casts next to each other.
#pragma once

#include "edgewise/geometry/vec.hpp"

namespace edgewise {

/// Returns the double nearest to x that single precision holds; infinite beyond its range.
[[nodiscard]] inline double to_single(double x) {
    const volatile float single = static_cast<float>(x);
    return static_cast<double>(single);
}

[[nodiscard]] inline Vec3d to_single(const Vec3d& v) {
    return {to_single(v.x()), to_single(v.y()), to_single(v.z())};
}

}  // namespace edgewise
