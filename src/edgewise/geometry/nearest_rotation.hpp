// SPDX-License-Identifier: MIT
//
// Matrices that users write for rotations: in case files, in messages of other programs, on the command line.
// They have as many digits as were printed. A matrix that is nearly a rotation is replaced by the nearest
// one, so that everything after it (answers, exact answers, certificates) is about the same bodies. A scale,
// a mirror image or a typing error is refused: no answer about another matrix would be the user's.
#pragma once

#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/result.hpp"

namespace edgewise {

/// The rotation nearest to the matrix R (its orthogonal polar factor), or R itself where that is one to
/// rounding. The warning says how far R was from a rotation, if it was changed. The error says what R is:
/// zero, flat, a scale, a mirror image. Neither names the place of R: "is 0.001 times a rotation: ...".
[[nodiscard]] Result<Mat3d> nearest_rotation(const Mat3d& r);

}  // namespace edgewise
