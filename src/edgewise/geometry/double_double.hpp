// SPDX-License-Identifier: MIT
//
// An unevaluated sum of two doubles: about 106 bits, for the few places where a difference of nearly equal
// products decides (the plane of a sliver face, the thickness of a needle, a simplex that nearly holds the
// origin). Error-free sums after Knuth and Dekker (1971), error-free products by fma; the fma is explicit and
// correctly rounded, so the bits are the same everywhere.
#pragma once

#include <cmath>
#include <type_traits>

#include "edgewise/geometry/vec.hpp"

namespace edgewise {

struct DoubleDouble {
    double high, low;

    constexpr DoubleDouble(double high_part = 0, double low_part = 0) : high(high_part), low(low_part) {}

    [[nodiscard]] constexpr double value() const { return high + low; }
    [[nodiscard]] explicit constexpr operator double() const { return value(); }
};

/// The next wider arithmetic: double for single, sums of two doubles for double.
template <class Scalar>
using Wider = std::conditional_t<std::is_same_v<Scalar, float>, double, DoubleDouble>;

[[nodiscard]] inline DoubleDouble exact_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

[[nodiscard]] inline DoubleDouble exact_product(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

[[nodiscard]] inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

[[nodiscard]] inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble high = exact_sum(a.high, b.high);
    const DoubleDouble low = exact_sum(a.low, b.low);
    const DoubleDouble carried = exact_sum(high.high, high.low + low.high);
    return exact_sum(carried.high, carried.low + low.low);
}

[[nodiscard]] inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + (-b); }

[[nodiscard]] inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble product = exact_product(a.high, b.high);
    return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

/// Quotient by two steps of long division; about 100 bits.
[[nodiscard]] inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - b * DoubleDouble(first);
    const double second = rest.high / b.high;
    const double third = (rest - b * DoubleDouble(second)).high / b.high;
    return exact_sum(first, second) + DoubleDouble(third);
}

inline DoubleDouble& operator+=(DoubleDouble& a, const DoubleDouble& b) { return a = a + b; }

[[nodiscard]] inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
}
[[nodiscard]] inline bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
[[nodiscard]] inline bool operator>=(const DoubleDouble& a, const DoubleDouble& b) { return !(a < b); }
[[nodiscard]] inline DoubleDouble abs(const DoubleDouble& a) { return a < DoubleDouble() ? -a : a; }

}  // namespace edgewise

namespace Eigen {

/// Traits that Eigen requires of a scalar type.
template <>
struct NumTraits<edgewise::DoubleDouble> : GenericNumTraits<edgewise::DoubleDouble> {
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 1,
        ReadCost = 2,
        AddCost = 20,
        MulCost = 10
    };
};

}  // namespace Eigen

namespace edgewise {

using DoubleDoubleVec = Vec3<DoubleDouble>;

/// (a - b) * scale without rounding, for a scale that is a power of two.
[[nodiscard]] inline DoubleDoubleVec exact_difference(const Vec3d& a, const Vec3d& b, double scale) {
    const auto component = [scale](double p, double q) {
        const DoubleDouble d = exact_sum(p, -q);
        return DoubleDouble{d.high * scale, d.low * scale};
    };
    return {component(a.x(), b.x()), component(a.y(), b.y()), component(a.z(), b.z())};
}

/// <a, b> of plain doubles, rounded once or nearly so.
[[nodiscard]] inline DoubleDouble accurate_dot(const Vec3d& a, const Vec3d& b) {
    return exact_product(a.x(), b.x()) + exact_product(a.y(), b.y()) + exact_product(a.z(), b.z());
}

}  // namespace edgewise
