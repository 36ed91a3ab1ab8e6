// SPDX-License-Identifier: MIT
#include "edgewise/truth/filter/posed_pair.hpp"

#include <algorithm>
#include <cmath>

namespace edgewise::truth {

namespace {

/// Upward from a sum of three squares in double, which is off by 3u, and its root by 1.5u and 1u.
double root_up(double squares) { return std::sqrt(squares) * (1 + 3 * proof_rounding); }

double squared_entries(const Mat3d& r) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += squared_norm(r.row(i));
    return sum;
}

/// Products of eight lengths must neither overflow nor vanish.
bool in_range(double length) { return length >= 0x1p-100 && length <= 0x1p100; }

}  // namespace

PosedPair::PosedPair(ScannedBody& a, const Pose& pose_a, ScannedBody& b, const Pose& pose_b)
    : a_(a), b_(b), pose_a_(pose_a), pose_b_(pose_b), offset_(pose_b.translation - pose_a.translation) {
    constexpr double u = proof_rounding;
    stretch_a_ = root_up(squared_entries(pose_a.rotation));
    stretch_b_ = root_up(squared_entries(pose_b.rotation));
    ortho_ = std::max(ortho_error(pose_a.rotation), ortho_error(pose_b.rotation));
    offset_length_ = root_up(squared_norm(offset_));
    const double reaches = (a.reach() + b.reach()) * (1 + 16 * u);
    span_ = root_up(1 + 3 * ortho_ + 64 * u) * reaches + offset_length_;
    usable_ = in_range(span_) && ortho_ < 1;  // NaN is not
    const double turning = 3 * (stretch_a_ * a.reach() + stretch_b_ * b.reach());
    point_error_ = u * (turning + 2 * span_) * (1 + 16 * u);
}

ScannedLowest PosedPair::lowest(const Vec3d& direction) {
    constexpr double u = proof_rounding;
    const Vec3d in_a = multiply_transposed(pose_a_.rotation, direction);
    const Vec3d in_b = multiply_transposed(pose_b_.rotation, direction);
    const Highest low_a = a_.highest(-in_a);
    const Highest high_b = b_.highest(in_b);
    const double length = root_up(squared_norm(direction));
    const double along_offset = dot(direction, offset_);
    const double between = -low_a.height - high_b.height;
    const double height = between - along_offset;
    ScannedLowest result;
    result.pair = {low_a.vertex, high_b.vertex};
    result.point = difference(result.pair);
    result.height_a = low_a.height;
    result.height_b = high_b.height;
    result.error_a = 3 * u * a_.reach() * (stretch_a_ * length + root_up(squared_norm(in_a)));
    result.error_b = 3 * u * b_.reach() * (stretch_b_ * length + root_up(squared_norm(in_b)));
    const double rounding = result.error_a + result.error_b +
                            u * (4 * length * offset_length_ + std::abs(between) + std::abs(height));
    result.least_height = height - rounding * (1 + 16 * u) - u * std::abs(height);
    return result;
}

}  // namespace edgewise::truth
