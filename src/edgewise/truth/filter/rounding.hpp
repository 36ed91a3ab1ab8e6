// SPDX-License-Identifier: MIT
//
// Error bounds for proofs in double: no tolerances, only the largest error of each operation.
#pragma once

namespace edgewise::truth {

/// The unit of rounding of double, half of Tolerance<double>::eps, with a margin of 1/128 for terms of second
/// order and for what underflows.
inline constexpr double proof_rounding = 0x1.02p-53;

/// The bound of sums of two doubles, relative to the lengths in them: 2^-96 with a margin of 64.
inline constexpr double wide_rounding = 0x1p-90;

}  // namespace edgewise::truth
