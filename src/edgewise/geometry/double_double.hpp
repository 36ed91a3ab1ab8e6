// SPDX-License-Identifier: MIT
//
// An unevaluated sum of two doubles: about 106 bits, for the few places where a difference of nearly equal
// products decides (the plane of a sliver face, the thickness of a needle, a simplex that nearly holds the
// origin). Error-free sums after Knuth and Dekker (1971), error-free products by fma; the fma is explicit and
// correctly rounded, so the bits are the same everywhere.
#pragma once

#include <cmath>

#include "edgewise/geometry/vec.hpp"

namespace edgewise {

struct Twofold {
    double high, low;

    constexpr Twofold(double high_part = 0, double low_part = 0) : high(high_part), low(low_part) {}

    [[nodiscard]] constexpr double value() const { return high + low; }
    [[nodiscard]] explicit constexpr operator double() const { return value(); }
};

[[nodiscard]] inline Twofold exact_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

[[nodiscard]] inline Twofold exact_product(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

[[nodiscard]] inline Twofold operator-(const Twofold& a) { return {-a.high, -a.low}; }

[[nodiscard]] inline Twofold operator+(const Twofold& a, const Twofold& b) {
    const Twofold high = exact_sum(a.high, b.high);
    const Twofold low = exact_sum(a.low, b.low);
    const Twofold carried = exact_sum(high.high, high.low + low.high);
    return exact_sum(carried.high, carried.low + low.low);
}

[[nodiscard]] inline Twofold operator-(const Twofold& a, const Twofold& b) { return a + (-b); }

[[nodiscard]] inline Twofold operator*(const Twofold& a, const Twofold& b) {
    const Twofold product = exact_product(a.high, b.high);
    return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

/// Two steps of long division; about 100 bits.
[[nodiscard]] inline Twofold operator/(const Twofold& a, const Twofold& b) {
    const double first = a.high / b.high;
    const Twofold rest = a - b * Twofold(first);
    const double second = rest.high / b.high;
    const double third = (rest - b * Twofold(second)).high / b.high;
    return exact_sum(first, second) + Twofold(third);
}

inline Twofold& operator+=(Twofold& a, const Twofold& b) { return a = a + b; }

[[nodiscard]] inline bool operator<(const Twofold& a, const Twofold& b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
}
[[nodiscard]] inline bool operator>(const Twofold& a, const Twofold& b) { return b < a; }
[[nodiscard]] inline bool operator>=(const Twofold& a, const Twofold& b) { return !(a < b); }
[[nodiscard]] inline Twofold abs(const Twofold& a) { return a < Twofold() ? -a : a; }

struct TwofoldVec {
    Twofold x, y, z;

    [[nodiscard]] Vec3d value() const { return {x.value(), y.value(), z.value()}; }
};

/// (a - b) * scale without rounding, for a scale that is a power of two.
[[nodiscard]] inline TwofoldVec exact_difference(const Vec3d& a, const Vec3d& b, double scale) {
    const auto component = [scale](double p, double q) {
        const Twofold d = exact_sum(p, -q);
        return Twofold{d.high * scale, d.low * scale};
    };
    return {component(a.x(), b.x()), component(a.y(), b.y()), component(a.z(), b.z())};
}

[[nodiscard]] inline TwofoldVec operator+(const TwofoldVec& a, const TwofoldVec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

[[nodiscard]] inline Twofold dot(const TwofoldVec& a, const TwofoldVec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[nodiscard]] inline TwofoldVec cross(const TwofoldVec& a, const TwofoldVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// <a, b> of plain doubles, rounded once or nearly so.
[[nodiscard]] inline Twofold accurate_dot(const Vec3d& a, const Vec3d& b) {
    return exact_product(a.x(), b.x()) + exact_product(a.y(), b.y()) + exact_product(a.z(), b.z());
}

}  // namespace edgewise

namespace Eigen {

/// What Eigen wants to know of a scalar before it takes it.
template <>
struct NumTraits<edgewise::Twofold> : GenericNumTraits<edgewise::Twofold> {
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
