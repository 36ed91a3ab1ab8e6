// SPDX-License-Identifier: MIT
//
// Matrices that users write for rotations: in case files, in messages of other programs, on the command line.
// Such a matrix has only the digits that were printed. A matrix that is nearly a rotation is replaced by the
// nearest one, so that everything after it (answers, exact answers, certificates) is about the same bodies. A
// scale, a mirror image or a typing error is refused: no answer about another matrix would be the user's.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/result.hpp"
#include "edgewise/geometry/vec.hpp"

namespace edgewise {

namespace nearest_rotation_detail {

inline constexpr int shown_digits = 6;

/// A matrix as the lengths of its columns and their directions.
struct Directions {
    std::array<double, 3> lengths{};
    Mat3d unit = Mat3d::Zero();
};

/// Divided by the largest entry first: squares neither overflow nor vanish.
inline Directions directions_of(const Mat3d& r, double largest) {
    Directions result;
    for (int j = 0; j < 3; ++j) {
        const Vec3d column = r.col(j) / largest;
        const double length = norm(column);
        result.lengths[static_cast<std::size_t>(j)] = length * largest;
        if (length > 0) result.unit.col(j) = column / length;
    }
    return result;
}

/// A matrix with orthogonal columns.
inline std::string scale_text(const Directions& of) {
    const bool mirrors = of.unit.determinant() < 0;
    const auto [shortest, longest] = std::ranges::minmax(of.lengths);
    if (longest - shortest > sloppiest_written_rotation * longest)
        return message("scales the body's axes by ", rounded(of.lengths[0], shown_digits), ", ",
                       rounded(of.lengths[1], shown_digits), " and ", rounded(of.lengths[2], shown_digits),
                       mirrors ? " and mirrors it" : "", ": do so to the vertices instead");
    const double scale = of.lengths[0] / 3 + of.lengths[1] / 3 + of.lengths[2] / 3;
    if (mirrors && std::abs(scale - 1) <= sloppiest_written_rotation)
        return "is a mirror image (its determinant is -1): mirror the vertices instead";
    return message("is ", rounded(scale, shown_digits), " times a ", mirrors ? "mirror image" : "rotation",
                   mirrors ? ": scale and mirror the vertices instead" : ": scale the vertices instead");
}

/// Says why a matrix is refused that is too far from a rotation.
inline std::string what_it_is(const Mat3d& r) {
    const double largest = r.cwiseAbs().maxCoeff();
    if (largest == 0) return "is zero, and must be a rotation";
    const Directions of = directions_of(r, largest);
    if (std::abs(of.unit.determinant()) < sloppiest_written_rotation * sloppiest_written_rotation)
        return "flattens the body (its columns lie in one plane), and must be a rotation";
    if (ortho_error(of.unit) <= sloppiest_written_rotation) return scale_text(of);
    return message("is no rotation: R^T R differs from the identity by ", rounded(ortho_error(r)),
                   ", and at most ", sloppiest_written_rotation, " is taken");
}

}  // namespace nearest_rotation_detail

/// The rotation nearest to the matrix R (its orthogonal polar factor), or R itself where that is one to
/// rounding. The warning says how far R was from a rotation, if it was changed. The error says what R is:
/// zero, flat, a scale, a mirror image. Neither names the place of R: "is 0.001 times a rotation: ...".
[[nodiscard]] inline Result<Mat3d> nearest_rotation(const Mat3d& r) {
    const double off = ortho_error(r);
    if (!(off <= sloppiest_written_rotation) || r.determinant() < 0)
        return Result<Mat3d>::failure(nearest_rotation_detail::what_it_is(r));
    if (off <= written_rotation_rounding) return Result<Mat3d>::success(r);
    return Result<Mat3d>::success(orthonormalised({r, Vec3d::Zero()}, Vec3d::Zero()).rotation,
                                  message("is ", rounded(off), " from a rotation"));
}

}  // namespace edgewise
