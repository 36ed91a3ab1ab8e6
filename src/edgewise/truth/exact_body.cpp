// SPDX-License-Identifier: MIT
//
// Integer world coordinates on demand, and exact support by a filtered scan: only what the filter cannot
// distinguish is compared exactly.
#include "edgewise/truth/exact_body.hpp"

#include <algorithm>

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

}  // namespace

std::string pair_error(std::span<const Vec3d> a, const Pose& pose_a, std::span<const Vec3d> b,
                       const Pose& pose_b) {
    const std::string error = body_error(a, pose_a, "A");
    return error.empty() ? body_error(b, pose_b, "B") : error;
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
