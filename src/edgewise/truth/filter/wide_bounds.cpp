// SPDX-License-Identifier: MIT
#include "edgewise/truth/filter/wide_bounds.hpp"

#include <algorithm>
#include <limits>

#include "edgewise/geometry/double_double.hpp"
#include "edgewise/truth/filter/rounding.hpp"

namespace edgewise::truth {

namespace {

/// R v
DoubleDoubleVec turned(const Pose& pose, const Vec3d& v) {
    DoubleDoubleVec result;
    for (int i = 0; i < 3; ++i) result[i] = accurate_dot(Vec3d(pose.rotation.row(i)), v);
    return result;
}

DoubleDoubleVec minus(const DoubleDoubleVec& a, const DoubleDoubleVec& b) {
    return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
}

DoubleDouble along(const Vec3d& direction, const DoubleDoubleVec& v) {
    return v.x() * DoubleDouble(direction.x()) + v.y() * DoubleDouble(direction.y()) +
           v.z() * DoubleDouble(direction.z());
}

DoubleDoubleVec offset_of(const PosedPair& pair) {
    return exact_difference(pair.pose_b().translation, pair.pose_a().translation, 1);
}

/// The highest of the candidates along the direction.
DoubleDouble highest(std::span<const std::uint32_t> candidates, const ScannedBody& body, const Pose& pose,
                     const Vec3d& direction) {
    DoubleDouble best = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : candidates) {
        const DoubleDouble height = along(direction, turned(pose, body.vertex(i)));
        if (height > best) best = height;
    }
    return best;
}

}  // namespace

double wide_least_height(PosedPair& pair, const Vec3d& direction, const ScannedLowest& scanned) {
    constexpr double u = proof_rounding;
    const auto of_a = pair.a().as_high_as(scanned.height_a - 2.5 * scanned.error_a);
    const auto of_b = pair.b().as_high_as(scanned.height_b - 2.5 * scanned.error_b);
    const DoubleDouble least_a = -highest(of_a, pair.a(), pair.pose_a(), -direction);
    const DoubleDouble most_b = highest(of_b, pair.b(), pair.pose_b(), direction);
    const double height = (least_a - most_b - along(direction, offset_of(pair))).value();
    return height - u * std::abs(height) - wide_rounding * pair.span();
}

double wide_length(const PosedPair& pair, const MinimumSimplex<Vec3d>& simplex,
                   const std::array<double, 3>& weights) {
    constexpr double u = proof_rounding;
    const DoubleDoubleVec offset = offset_of(pair);
    DoubleDoubleVec sum = DoubleDoubleVec::Zero();
    DoubleDouble total;
    for (int i = 0; i < simplex.size; ++i) {
        const VertexPair corner = simplex.pair[i];
        const DoubleDoubleVec point = minus(minus(turned(pair.pose_a(), pair.a().vertex(corner.a)),
                                                  turned(pair.pose_b(), pair.b().vertex(corner.b))),
                                            offset);
        const DoubleDouble weight = weights[i];
        sum = {sum.x() + weight * point.x(), sum.y() + weight * point.y(), sum.z() + weight * point.z()};
        total += weight;
    }
    const Vec3d mean = Vec3d(sum.x().value(), sum.y().value(), sum.z().value()) / total.value();
    return norm(mean) * (1 + 16 * u) + wide_rounding * pair.span();
}

}  // namespace edgewise::truth
