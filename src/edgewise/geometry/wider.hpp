// SPDX-License-Identifier: MIT
//
// The next wider arithmetic: double for single, sums of two doubles for double.
#pragma once

#include <type_traits>

#include "edgewise/geometry/double_double.hpp"

namespace edgewise {

template <class Scalar>
using Wider = std::conditional_t<std::is_same_v<Scalar, float>, double, DoubleDouble>;

}  // namespace edgewise
