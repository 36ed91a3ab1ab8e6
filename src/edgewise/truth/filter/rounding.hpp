// SPDX-License-Identifier: MIT
//
// What proofs in double are made of: no tolerances, but how far an operation can be off.
#pragma once

namespace edgewise::truth {

/// The unit of rounding of double, half of Tolerance<double>::eps, with a margin of 1/128 for terms of second
/// order and for what underflows.
inline constexpr double proof_rounding = 0x1.02p-53;

/// The bound of sums of two doubles, relative to the lengths in them: 2^-96 with a margin of 64.
inline constexpr double wide_rounding = 0x1p-90;

}  // namespace edgewise::truth
