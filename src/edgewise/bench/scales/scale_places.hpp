// SPDX-License-Identifier: MIT
//
// Place of the second body of a pair while it turns, step by step.
#pragma once

#include <cstddef>

#include "edgewise/geometry/pose.hpp"

namespace edgewise::bench {

/// The place turned about its z axis by an angle with a sine that grows by 0.025 per step. Outside the query
/// loops, which have flags that let the compiler fuse this product's multiplications and additions.
[[nodiscard]] Transform<double> turned_place(const Transform<double>& place, std::size_t step);

}  // namespace edgewise::bench
