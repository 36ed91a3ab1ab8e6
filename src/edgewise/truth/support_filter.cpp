// SPDX-License-Identifier: MIT
//
// The error bound of the filter (Tolerance::support_filter), in units where |v - v0| < 2 and |R| < 2 by entry
// and the direction's entries are below 1; u = 2^-53. A product of a row: the difference is off by 2u, which
// the matrix doubles, and the product rounds by 4u: 8u; three of them, and two sums (8u, 12u): 44u for a
// coordinate below 12. Height: 3 * 44u from the coordinates, 3 * 12 * 2u from the truncated direction, 3 *
// 12u + 24u + 36u from its own products and sums: 300u. The bound is 512u = 2^-44; what is left covers
// second-order terms and everything that underflows after scaling (below 2^-1000).
#include "edgewise/truth/support_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>

#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::truth {

namespace {

/// Divides by 2^exponent in two steps: the power alone may not fit a double.
auto divider(int exponent) {
    const double first = std::ldexp(1.0, -exponent / 2);
    const double second = std::ldexp(1.0, -exponent - (-exponent / 2));
    return [=](const auto& x) -> std::remove_cvref_t<decltype(x)> { return (x * first) * second; };
}

}  // namespace

SupportFilter::SupportFilter(std::span<const Vec3d> vertices, const Mat3d& rotation) {
    const std::size_t count = vertices.size();
    double reach = 0;
    for (const Vec3d& v : vertices) reach = std::max(reach, max_abs(Vec3d(v - vertices[0])));
    const double gain = rotation.cwiseAbs().maxCoeff();
    usable_ = std::isfinite(reach);
    candidates_.resize(count);
    if (!usable_) {
        std::iota(candidates_.begin(), candidates_.end(), 0U);
        return;
    }
    const int reach_exponent = reach > 0 ? std::ilogb(reach) : 0;
    const int gain_exponent = gain > 0 ? std::ilogb(gain) : 0;
    exponent_ = reach_exponent + gain_exponent;
    const auto divide = divider(reach_exponent);
    const Mat3d matrix = divider(gain_exponent)(rotation);
    for (std::vector<double>* list : {&x_, &y_, &z_, &heights_}) list->resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d shape = multiply(matrix, divide(Vec3d(vertices[i] - vertices[0])));
        x_[i] = shape.x();
        y_[i] = shape.y();
        z_[i] = shape.z();
    }
}

void SupportFilter::scan(const Vec3d& direction) {
    const std::size_t count = heights_.size();
    for (std::size_t i = 0; i < count; ++i) {
        heights_[i] = direction.x() * x_[i] + direction.y() * y_[i] + direction.z() * z_[i];
    }
}

std::uint32_t SupportFilter::lowest(const Vec3d& direction) {
    scan(direction);
    return static_cast<std::uint32_t>(std::min_element(heights_.begin(), heights_.end()) - heights_.begin());
}

std::span<const std::uint32_t> SupportFilter::candidates(const Vec3d& direction) {
    if (!usable_) return candidates_;
    scan(direction);
    const double best = *std::min_element(heights_.begin(), heights_.end());
    const double limit = best + 2 * Tolerance<double>::support_filter;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < heights_.size(); ++i) {
        if (heights_[i] <= limit) candidates_[kept++] = static_cast<std::uint32_t>(i);
    }
    return std::span<const std::uint32_t>(candidates_).first(kept);
}

Vec3d rounded_direction(const IntegerVec& direction) {
    std::array<long, 3> exponent{};
    Vec3d mantissa = mantissas(direction, exponent);
    long top = std::numeric_limits<long>::min();
    for (int i = 0; i < 3; ++i) {
        if (mantissa[i] != 0) top = std::max(top, exponent[i]);
    }
    for (int i = 0; i < 3; ++i) {
        if (mantissa[i] == 0) continue;
        mantissa[i] = std::ldexp(mantissa[i], static_cast<int>(std::max(exponent[i] - top, -4000L)));
    }
    return mantissa;
}

}  // namespace edgewise::truth
