// SPDX-License-Identifier: MIT
//
// Caps on loops that end by an argument: far beyond what any body needs, so that only a shape that breaks its
// contract meets one. Each asserts in debug; in release the query says that it failed.
#pragma once

namespace edgewise {

/// Iterations per GJK query. Every one lowers the distance by more than rounding, or ends the run; spheres of
/// 1538 vertices take up to some dozen. A thousandfold of that is a tenth of a second.
inline constexpr int most_gjk_iterations = 1 << 14;

}  // namespace edgewise
