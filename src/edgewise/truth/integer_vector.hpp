// SPDX-License-Identifier: MIT
//
// Vectors of GMP integers. The products are written with mpz_addmul and mpz_submul instead of gmpxx
// expressions, which would make a temporary for every term.
#pragma once

#include <gmpxx.h>

#include <array>

#include "edgewise/geometry/vec.hpp"

namespace edgewise::truth {

using edgewise::cross, edgewise::dot;

struct IntegerVec {
    mpz_class x, y, z;

    [[nodiscard]] bool is_zero() const { return sgn(x) == 0 && sgn(y) == 0 && sgn(z) == 0; }
};

[[nodiscard]] inline IntegerVec operator-(const IntegerVec& a, const IntegerVec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

[[nodiscard]] inline IntegerVec operator-(const IntegerVec& a) { return {-a.x, -a.y, -a.z}; }

inline IntegerVec& operator+=(IntegerVec& a, const IntegerVec& b) {
    a.x += b.x;
    a.y += b.y;
    a.z += b.z;
    return a;
}

[[nodiscard]] inline IntegerVec operator*(const mpz_class& factor, const IntegerVec& a) {
    return {factor * a.x, factor * a.y, factor * a.z};
}

[[nodiscard]] inline bool operator==(const IntegerVec& a, const IntegerVec& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

[[nodiscard]] inline mpz_class dot(const IntegerVec& a, const IntegerVec& b) {
    mpz_class sum;
    mpz_mul(sum.get_mpz_t(), a.x.get_mpz_t(), b.x.get_mpz_t());
    mpz_addmul(sum.get_mpz_t(), a.y.get_mpz_t(), b.y.get_mpz_t());
    mpz_addmul(sum.get_mpz_t(), a.z.get_mpz_t(), b.z.get_mpz_t());
    return sum;
}

/// Each entry as a mantissa in [0.5, 1), with its exponent; zero with the exponent 0.
[[nodiscard]] inline Vec3d mantissas(const IntegerVec& v, std::array<long, 3>& exponents) {
    const auto entry = [&](const mpz_class& x, int i) {
        return mpz_get_d_2exp(&exponents[i], x.get_mpz_t());
    };
    return {entry(v.x, 0), entry(v.y, 1), entry(v.z, 2)};
}

/// p q - r s
[[nodiscard]] inline mpz_class minor_of(const mpz_class& p, const mpz_class& q, const mpz_class& r,
                                        const mpz_class& s) {
    mpz_class result;
    mpz_mul(result.get_mpz_t(), p.get_mpz_t(), q.get_mpz_t());
    mpz_submul(result.get_mpz_t(), r.get_mpz_t(), s.get_mpz_t());
    return result;
}

[[nodiscard]] inline IntegerVec cross(const IntegerVec& a, const IntegerVec& b) {
    return {minor_of(a.y, b.z, a.z, b.y), minor_of(a.z, b.x, a.x, b.z), minor_of(a.x, b.y, a.y, b.x)};
}

/// Some vector perpendicular to this one, which is not zero.
[[nodiscard]] inline IntegerVec perpendicular_to(const IntegerVec& a) {
    const IntegerVec normal = cross(a, IntegerVec{1, 0, 0});
    return normal.is_zero() ? cross(a, IntegerVec{0, 1, 0}) : normal;
}

/// The sign of a number as -1, 0 or 1; the double twin lets one text serve both number types.
[[nodiscard]] inline int sign(const mpz_class& value) { return sgn(value); }
[[nodiscard]] inline int sign(double value) { return (value > 0) - (value < 0); }

}  // namespace edgewise::truth
