// SPDX-License-Identifier: MIT
//
// Conversions between doubles and integers with a power of two. A quotient or a root is computed to about 70
// bits, a sticky bit represents the rest, and the result is rounded once: no double rounding, also for
// denormals.
#include "edgewise/truth/dyadic.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace edgewise::truth {

namespace {

constexpr long kept_bits = 70;  // 53 bits, a half bit, and room to spare below them

long bit_length(const mpz_class& value) { return static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2)); }

/// Rounds magnitude * 2^exponent (magnitude > 0). A sticky bit must be in its last place already.
double round_to_double(const mpz_class& magnitude, long exponent) {
    constexpr long smallest = -1074;
    const long target = std::max(bit_length(magnitude) + exponent - 53, smallest);
    const long drop = target - exponent;
    if (drop <= 0) return std::ldexp(magnitude.get_d(), static_cast<int>(exponent));
    mpz_class quotient = magnitude >> static_cast<mp_bitcnt_t>(drop);
    const mp_bitcnt_t half_bit = static_cast<mp_bitcnt_t>(drop - 1);
    const bool half = mpz_tstbit(magnitude.get_mpz_t(), half_bit) != 0;
    const bool beyond = half && mpz_scan1(magnitude.get_mpz_t(), 0) < half_bit;
    if (half && (beyond || mpz_odd_p(quotient.get_mpz_t()))) ++quotient;
    return std::ldexp(quotient.get_d(), static_cast<int>(std::min(target, 4096L)));
}

/// floor(numerator * 2^shift / denominator) for numerator >= 0; notes in `exact` whether nothing was cut off.
mpz_class shifted_quotient(const mpz_class& numerator, const mpz_class& denominator, long shift,
                           bool& exact) {
    const mp_bitcnt_t up = static_cast<mp_bitcnt_t>(std::max(shift, 0L));
    const mp_bitcnt_t down = static_cast<mp_bitcnt_t>(std::max(-shift, 0L));
    const mpz_class top = numerator << up;
    const mpz_class bottom = denominator << down;
    mpz_class quotient, remainder;
    mpz_tdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), top.get_mpz_t(), bottom.get_mpz_t());
    exact = sgn(remainder) == 0;
    return quotient;
}

/// Appends the sticky bit and rounds.
double finish(const mpz_class& digits, bool exact, long exponent) {
    const mpz_class with_sticky = 2 * digits + (exact ? 0 : 1);
    return round_to_double(with_sticky, exponent - 1);
}

/// The sign of x - sqrt(numerator / denominator) * 2^exponent, for x >= 0.
int compare_to_root(double x, const mpz_class& numerator, const mpz_class& denominator, long exponent) {
    if (std::isinf(x)) return 1;
    const Dyadic d = dyadic(x);
    if (d.mantissa == 0) return -sgn(numerator);
    const mpz_class mantissa = d.mantissa;
    const mpz_class square = mantissa * mantissa * denominator;
    const long shift = 2 * (d.exponent - exponent);
    const mpz_class left = square << static_cast<mp_bitcnt_t>(std::max(shift, 0L));
    const mpz_class right = numerator << static_cast<mp_bitcnt_t>(std::max(-shift, 0L));
    return cmp(left, right);
}

}  // namespace

Dyadic dyadic(double value) {
    constexpr std::uint64_t fraction_mask = (std::uint64_t{1} << 52) - 1;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
    const long biased = static_cast<long>(bits >> 52 & 0x7ff);
    const std::uint64_t fraction = bits & fraction_mask;
    const std::uint64_t magnitude = biased == 0 ? fraction : fraction | (fraction_mask + 1);
    if (magnitude == 0) return {0, exponent_of_zero};
    const int zeros = std::countr_zero(magnitude);
    const long mantissa = static_cast<long>(magnitude >> zeros);
    return {std::signbit(value) ? -mantissa : mantissa, std::max(biased, 1L) - 1075 + zeros};
}

mpz_class scaled(double value, long unit) {
    const Dyadic d = dyadic(value);
    mpz_class whole = d.mantissa;
    if (d.mantissa != 0) whole <<= static_cast<mp_bitcnt_t>(d.exponent - unit);
    return whole;
}

double rounded_quotient(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
    if (sgn(numerator) == 0) return 0;
    const long shift = kept_bits - (bit_length(numerator) - bit_length(denominator));
    bool exact = false;
    const mpz_class digits = shifted_quotient(abs(numerator), denominator, shift, exact);
    const double magnitude = finish(digits, exact, exponent - shift);
    return sgn(numerator) < 0 ? -magnitude : magnitude;
}

double rounded_root(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
    if (sgn(numerator) == 0) return 0;
    const long half_shift = kept_bits - (bit_length(numerator) - bit_length(denominator)) / 2;
    bool exact = false;
    const mpz_class square = shifted_quotient(numerator, denominator, 2 * half_shift, exact);
    mpz_class digits, remainder;
    mpz_sqrtrem(digits.get_mpz_t(), remainder.get_mpz_t(), square.get_mpz_t());
    return finish(digits, exact && sgn(remainder) == 0, exponent - half_shift);
}

double root_rounded_down(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
    const double nearest = rounded_root(numerator, denominator, exponent);
    if (compare_to_root(nearest, numerator, denominator, exponent) <= 0) return nearest;
    return std::nextafter(nearest, 0.0);
}

double root_rounded_up(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
    const double nearest = rounded_root(numerator, denominator, exponent);
    if (compare_to_root(nearest, numerator, denominator, exponent) >= 0) return nearest;
    return std::nextafter(nearest, std::numeric_limits<double>::infinity());
}

}  // namespace edgewise::truth
