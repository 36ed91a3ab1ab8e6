// SPDX-License-Identifier: MIT
//
// Where the second body of a pair stands while it turns, step by step.
#pragma once

#include <cstddef>

#include "edgewise/geometry/pose.hpp"

namespace edgewise::bench {

/// The place turned about its z axis by an angle whose sine grows by 0.025 per step. Out of the query loops,
/// whose flags let the compiler fuse this product's multiplications and additions.
[[nodiscard]] Transform<double> turned_place(const Transform<double>& place, std::size_t step);

}  // namespace edgewise::bench
