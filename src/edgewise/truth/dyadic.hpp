// SPDX-License-Identifier: MIT
//
// Doubles as what they are: an integer of at most 53 bits times a power of two. And back: exact quotients and
// roots of quotients rounded once, to the nearest double (ties to even, gradual underflow, overflow to
// infinity).
#pragma once

#include <gmpxx.h>

#include <algorithm>

#include "edgewise/truth/integer_vector.hpp"

namespace edgewise::truth {

/// value = mantissa * 2^exponent, mantissa odd or zero.
struct Dyadic {
    long mantissa;
    long exponent;
};

/// Exponent reported for zero: above that of any double, so that it never lowers a minimum.
inline constexpr long exponent_of_zero = 1L << 20;

[[nodiscard]] Dyadic dyadic(double value);

/// The least exponent among these numbers.
template <class Numbers>
[[nodiscard]] long least_exponent(const Numbers& numbers) {
    long least = exponent_of_zero;
    for (const double x : numbers) least = std::min(least, dyadic(x).exponent);
    return least;
}

/// value / 2^unit; unit must be at most the exponent of the value.
[[nodiscard]] mpz_class scaled(double value, long unit);
[[nodiscard]] inline IntegerVec scaled(const Vec3d& v, long unit) {
    return {scaled(v.x(), unit), scaled(v.y(), unit), scaled(v.z(), unit)};
}

/// The double nearest to (numerator / denominator) * 2^exponent; denominator positive.
[[nodiscard]] double rounded_quotient(const mpz_class& numerator, const mpz_class& denominator,
                                      long exponent);

/// The double nearest to sqrt(numerator / denominator) * 2^exponent; numerator not negative, denominator
/// positive.
[[nodiscard]] double rounded_root(const mpz_class& numerator, const mpz_class& denominator, long exponent);

/// sqrt(numerator / denominator) * 2^exponent, rounded to the nearest double below, or above, unless exact.
[[nodiscard]] double root_rounded_down(const mpz_class& numerator, const mpz_class& denominator,
                                       long exponent);
[[nodiscard]] double root_rounded_up(const mpz_class& numerator, const mpz_class& denominator, long exponent);

}  // namespace edgewise::truth
