// SPDX-License-Identifier: MIT
//
// Where a body is: x_world = R x + t with R and t exactly as given. R should be a rotation but is never
// re-normalised: the answer is for the R given (`ortho_error` is its distance from orthogonal).
//
// Queries run in the frame of body A, so that a far-off origin costs no digits: the two origins are
// subtracted first, in double, and only then rotated.
#pragma once

#include <cmath>
#include <type_traits>

#include "edgewise/geometry/inlining.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/geometry/vec.hpp"

namespace edgewise {

struct Pose {
    Mat3d rotation = Mat3d::Identity();
    Vec3d translation = Vec3d::Zero();

    [[nodiscard]] Vec3d apply(const Vec3d& point) const { return multiply(rotation, point) + translation; }
};

/// A rigid map between the frames of two bodies, in the precision that computes.
template <class Scalar>
struct Transform {
    Mat3<Scalar> rotation;
    Vec3<Scalar> translation;

    [[nodiscard]] Vec3<Scalar> point(const Vec3<Scalar>& p) const {
        return multiply(rotation, p) + translation;
    }
    [[nodiscard]] Vec3<Scalar> direction(const Vec3<Scalar>& d) const { return multiply(rotation, d); }
    [[nodiscard]] Vec3<Scalar> direction_back(const Vec3<Scalar>& d) const {
        return multiply_transposed(rotation, d);
    }

    /// Transpose: the inverse as far as the rotation is orthogonal.
    [[nodiscard]] Transform inverse() const {
        return {rotation.transpose(), -multiply_transposed(rotation, translation)};
    }
};

/// The map that takes B's points into A's frame; computed in double whatever the tables hold. It uses R_A's
/// transpose as its inverse. Rotations with more than rounding error (`is_orthonormalised` is false: matrices
/// in single, or typed in) should go through `orthonormalised` first, because otherwise a long offset is
/// stretched. Flattened: a product that is called reads its vector from memory, just stored (25 of 102 ns).
[[nodiscard]] EDGEWISE_FLATTENED inline Transform<double> relative_pose(const Pose& a, const Pose& b) {
    Transform<double> result;
    for (int i = 0; i < 3; ++i)  // by rows, as they are stored
        result.rotation.row(i) = a.rotation(0, i) * b.rotation.row(0) + a.rotation(1, i) * b.rotation.row(1) +
                                 a.rotation(2, i) * b.rotation.row(2);
    result.translation = multiply_transposed(a.rotation, Vec3d(b.translation - a.translation));
    return result;
}

template <class To, class From>
[[nodiscard]] Transform<To> cast(const Transform<From>& t) {
    return {t.rotation.template cast<To>(), t.translation.template cast<To>()};
}

/// Returns the map in this scalar: a reference to `t` if it has this scalar, else a copy. `t` must live
/// longer.
template <class To, class From>
[[nodiscard]] decltype(auto) in_scalar(const Transform<From>& t) {
    if constexpr (std::is_same_v<To, From>)
        return (t);
    else
        return cast<To>(t);
}

/// Distance of R from orthogonal: the largest entry of |R^T R - I|; NaN if one is.
[[nodiscard]] inline double ortho_error(const Mat3d& r) {
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j <= i; ++j) {
            const double product = dot(r.col(i), r.col(j));
            const double off = std::abs(product - (i == j ? 1.0 : 0.0));
            if (!(off <= worst)) worst = std::isnan(worst) ? worst : off;
        }
    }
    return worst;
}

/// Returns true if the rotation is orthogonal to within rounding.
[[nodiscard]] inline bool is_orthonormalised(const Pose& pose) {
    return ortho_error(pose.rotation) <= rotation_rounding;
}

/// The pose with its rotation made orthogonal, if its error is more than rounding (matrices in single, or
/// typed in): queries in the frame of A transform offsets by the transpose, and would stretch a long offset.
/// The point `about` of the body stays where it is, so that no other point moves by more than the distance of
/// R from orthogonal times the body's extent. The band of a verdict allows for that.
[[nodiscard]] inline Pose orthonormalised(const Pose& pose, const Vec3d& about) {
    Pose result = pose;
    for (int i = 0; i < 8 && !is_orthonormalised(result); ++i) {
        const Mat3d r = result.rotation;
        for (int j = 0; j < 3; ++j) {
            // Newton's step, column by column: R (3 - R^T R) / 2.
            const Vec3d column = r.col(j);
            const Vec3d square = multiply_transposed(r, column);
            result.rotation.col(j) = 1.5 * column - 0.5 * multiply(r, square);
        }
    }
    result.translation += multiply(Mat3d(pose.rotation - result.rotation), about);
    return result;
}

}  // namespace edgewise
