// SPDX-License-Identifier: MIT
//
// Integer world coordinates on demand, and exact support by a filtered scan: only what the filter cannot
// distinguish is compared exactly.
//
// The error bound of the filter (Tolerance::support_filter), in units where |v - v0| < 2 and |R| < 2 by entry
// and the direction's entries are below 1; u = 2^-53. A product of a row: the difference is off by 2u, which
// the matrix doubles, and the product rounds by 4u: 8u; three of them, and two sums (8u, 12u): 44u for a
// coordinate below 12. Height: 3 * 44u from the coordinates, 3 * 12 * 2u from the truncated direction, 3 *
// 12u + 24u + 36u from its own products and sums: 300u. The bound is 512u = 2^-44; what is left covers
// second-order terms and everything that underflows after scaling (below 2^-1000).
#include "edgewise/truth/exact_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/dyadic.hpp"

namespace edgewise::truth {

namespace {

long least_exponent_of(std::span<const Vec3d> points) {
    long least = exponent_of_zero;
    for (const Vec3d& p : points) least = std::min(least, least_exponent(p));
    return least;
}

/// Names the body and what to give instead.
std::string body_error(std::span<const Vec3d> vertices, const Pose& pose, const char* body) {
    const std::string where = std::string("body ") + body + ": ";
    if (vertices.empty()) return where + "no vertices; give at least one point";
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (vertices[i].allFinite()) continue;
        return where + "vertex " + std::to_string(i) + " is not finite; give finite coordinates";
    }
    if (!pose.rotation.allFinite()) return where + "rotation is not finite; give nine finite numbers";
    if (!pose.translation.allFinite()) return where + "translation is not finite; give three finite numbers";
    return {};
}

/// Divides by 2^exponent in two steps: the power alone may not fit a double.
auto divider(int exponent) {
    const double first = std::ldexp(1.0, -exponent / 2);
    const double second = std::ldexp(1.0, -exponent - (-exponent / 2));
    return [=](const auto& x) -> std::remove_cvref_t<decltype(x)> { return (x * first) * second; };
}

}  // namespace

std::string pair_error(std::span<const Vec3d> a, const Pose& pose_a, std::span<const Vec3d> b,
                       const Pose& pose_b) {
    const std::string error = body_error(a, pose_a, "A");
    return error.empty() ? body_error(b, pose_b, "B") : error;
}

std::vector<Vec3d> SupportFilter::shapes_of(std::span<const Vec3d> vertices, const Mat3d& rotation) {
    std::vector<Vec3d> shapes(vertices.size(), Vec3d::Zero());
    double reach = 0;
    for (const Vec3d& v : vertices) reach = std::max(reach, max_abs(Vec3d(v - vertices[0])));
    const double gain = rotation.cwiseAbs().maxCoeff();
    usable_ = std::isfinite(reach);
    if (!usable_) return shapes;
    const int reach_exponent = reach > 0 ? std::ilogb(reach) : 0;
    const int gain_exponent = gain > 0 ? std::ilogb(gain) : 0;
    exponent_ = reach_exponent + gain_exponent;
    const auto divide = divider(reach_exponent);
    const Mat3d matrix = divider(gain_exponent)(rotation);
    for (std::size_t i = 0; i < shapes.size(); ++i)
        shapes[i] = multiply(matrix, divide(Vec3d(vertices[i] - vertices[0])));
    return shapes;
}

std::span<const std::uint32_t> SupportFilter::candidates(const Vec3d& direction) {
    if (!usable_) return scanned_.as_high_as(-std::numeric_limits<double>::infinity());  // all
    return scanned_.as_high_as(scanned_.highest(-direction).height - 2 * Tolerance<double>::support_filter);
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

long ExactBody::unit_exponent(std::span<const Vec3d> vertices, const Pose& pose) {
    const long product = least_exponent(pose.rotation.reshaped()) + least_exponent_of(vertices);
    return std::min(product, least_exponent(pose.translation));
}

ExactBody::ExactBody(std::span<const Vec3d> vertices, const Pose& pose, long unit)
    : vertices_(vertices), filter_(vertices, pose.rotation), slot_(vertices.size(), not_yet) {
    // All-zero vertices or an all-zero matrix have no exponent of their own; any that fits will do.
    const long rotation_unit = least_exponent(pose.rotation.reshaped());
    vertex_unit_ = least_exponent_of(vertices);
    if (vertex_unit_ == exponent_of_zero) vertex_unit_ = unit - std::min(rotation_unit, 0L);
    for (int i = 0; i < 3; ++i) row_[i] = scaled(Vec3d(pose.rotation.row(i)), unit - vertex_unit_);
    translation_ = scaled(pose.translation, unit);
}

const IntegerVec& ExactBody::world(std::uint32_t i) {
    if (slot_[i] != not_yet) return world_[slot_[i]];
    slot_[i] = static_cast<std::uint32_t>(world_.size());
    const IntegerVec vertex = scaled(vertices_[i], vertex_unit_);
    IntegerVec result{dot(row_[0], vertex), dot(row_[1], vertex), dot(row_[2], vertex)};
    result += translation_;
    world_.push_back(std::move(result));
    return world_.back();
}

std::uint32_t ExactBody::lowest(const IntegerVec& direction) {
    const std::span<const std::uint32_t> candidates = filter_.candidates(rounded_direction(direction));
    if (candidates.size() == 1) return candidates.front();
    std::uint32_t best = candidates.front();
    mpz_class best_height = dot(direction, world(best));
    for (const std::uint32_t i : candidates.subspan(1)) {
        mpz_class height = dot(direction, world(i));
        if (height >= best_height) continue;
        best_height = std::move(height);
        best = i;
    }
    return best;
}

ExactPair::ExactPair(std::span<const Vec3d> vertices_a, const Pose& pose_a, std::span<const Vec3d> vertices_b,
                     const Pose& pose_b)
    : unit(std::min(
          {ExactBody::unit_exponent(vertices_a, pose_a), ExactBody::unit_exponent(vertices_b, pose_b), 0L})),
      a(vertices_a, pose_a, unit),
      b(vertices_b, pose_b, unit) {}

IntegerVec ExactPair::difference(VertexPair pair) { return a.world(pair.a) - b.world(pair.b); }

LowestPoint ExactPair::lowest(const IntegerVec& direction) {
    LowestPoint result;
    result.pair = {a.lowest(direction), b.lowest(-direction)};
    result.point = difference(result.pair);
    result.height = dot(direction, result.point);
    return result;
}

}  // namespace edgewise::truth
