// SPDX-License-Identifier: MIT
//
// Vectors, 3x3 matrices and planes: Eigen's types, with the products spelled out here.
//
// Eigen may sum a product in packets or with fused multiply-add, depending on the machine it is compiled for.
// Edgewise promises the same bits on every machine, so everything that sums goes through the functions below,
// which sum in the order of the source. Element-wise +, -, * are Eigen's own.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "edgewise/geometry/inlining.hpp"

#if !defined(EDGEWISE_ALLOW_FAST_MATH) && \
    (__FINITE_MATH_ONLY__ || defined(__ASSOCIATIVE_MATH__) || __FLT_EVAL_METHOD__ == 2)
#error \
    "Edgewise needs NaN and infinity, and sums as they are written: compile without -ffast-math, its parts and x87 arithmetic, or define EDGEWISE_ALLOW_FAST_MATH and hand over no pose with NaN or infinity"
#endif
#if !defined(EDGEWISE_CONTRACTION_KNOWN) && \
    (defined(__FMA__) || defined(__FP_FAST_FMA) || defined(__ARM_FEATURE_FMA))
#warning \
    "Edgewise: fused products change the last bits of answers: compile with -ffp-contract=off and define EDGEWISE_CONTRACTION_KNOWN, as the CMake package and pkg-config do"
#endif

namespace edgewise {

template <class Scalar>
using Vec3 = Eigen::Matrix<Scalar, 3, 1>;

/// Row-major, as case files and poses are written.
template <class Scalar>
using Mat3 = Eigen::Matrix<Scalar, 3, 3, Eigen::RowMajor>;

using Vec3d = Vec3<double>;
using Mat3d = Mat3<double>;

/// The vector in another scalar, component by component: g++ copies a whole Eigen vector through memory in
/// pieces of one size and reads it back in pieces of another, which stalls (15 % of a warm V-Clip query).
template <class To, class From>
[[nodiscard]] EDGEWISE_IN_QUERY_LOOP Vec3<To> cast(const Vec3<From>& v) {
    return {static_cast<To>(v.x()), static_cast<To>(v.y()), static_cast<To>(v.z())};
}

template <class A, class B>
[[nodiscard]] auto dot(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) -> typename A::Scalar {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

template <class A>
[[nodiscard]] auto squared_norm(const Eigen::MatrixBase<A>& a) -> typename A::Scalar {
    return a.x() * a.x() + a.y() * a.y() + a.z() * a.z();
}

template <class A>
[[nodiscard]] auto norm(const Eigen::MatrixBase<A>& a) -> typename A::Scalar {
    return std::sqrt(squared_norm(a));
}

template <class Scalar>
[[nodiscard]] EDGEWISE_IN_QUERY_LOOP Vec3<Scalar> cross(const Vec3<Scalar>& a, const Vec3<Scalar>& b) {
    return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

/// m * v, row by row.
template <class Scalar>
[[nodiscard]] EDGEWISE_IN_QUERY_LOOP Vec3<Scalar> multiply(const Mat3<Scalar>& m, const Vec3<Scalar>& v) {
    return {m(0, 0) * v.x() + m(0, 1) * v.y() + m(0, 2) * v.z(),
            m(1, 0) * v.x() + m(1, 1) * v.y() + m(1, 2) * v.z(),
            m(2, 0) * v.x() + m(2, 1) * v.y() + m(2, 2) * v.z()};
}

/// a * b, column by column.
template <class Scalar>
[[nodiscard]] Mat3<Scalar> multiply(const Mat3<Scalar>& a, const Mat3<Scalar>& b) {
    Mat3<Scalar> result;
    for (int i = 0; i < 3; ++i) result.col(i) = multiply(a, Vec3<Scalar>(b.col(i)));
    return result;
}

/// transpose(m) * v: for a rotation, its inverse.
template <class Scalar>
[[nodiscard]] EDGEWISE_IN_QUERY_LOOP Vec3<Scalar> multiply_transposed(const Mat3<Scalar>& m,
                                                                      const Vec3<Scalar>& v) {
    return {m(0, 0) * v.x() + m(1, 0) * v.y() + m(2, 0) * v.z(),
            m(0, 1) * v.x() + m(1, 1) * v.y() + m(2, 1) * v.z(),
            m(0, 2) * v.x() + m(1, 2) * v.y() + m(2, 2) * v.z()};
}

/// Largest absolute component.
template <class Scalar>
[[nodiscard]] EDGEWISE_IN_QUERY_LOOP Scalar max_abs(const Vec3<Scalar>& v) {
    return std::max(std::max(std::abs(v.x()), std::abs(v.y())), std::abs(v.z()));
}

/// An oriented plane <normal, p> + offset = 0; positive on the side the normal points to.
template <class Scalar>
struct Plane {
    Vec3<Scalar> normal;
    Scalar offset;

    /// Signed distance, in units of |normal|.
    [[nodiscard]] Scalar distance(const Vec3<Scalar>& p) const { return dot(normal, p) + offset; }
};

template <class To, class From>
[[nodiscard]] Plane<To> cast(const Plane<From>& p) {
    return {cast<To>(p.normal), static_cast<To>(p.offset)};
}

}  // namespace edgewise
