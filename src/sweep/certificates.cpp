// SPDX-License-Identifier: MIT
#include "edgewise/sweep/certificates.hpp"

#include <algorithm>
#include <vector>

#include "edgewise/geometry/single.hpp"

namespace edgewise {

namespace {

/// The feature's vertices as the stored body numbers them.
std::vector<Index> stored_vertices(const Polyhedron& stored, const NamedFeature& feature) {
    std::vector<Index> result;
    for (const Index name : feature.vertices) {
        const auto found = std::find(stored.input_index.begin(), stored.input_index.end(), name);
        if (found != stored.input_index.end()) {
            result.push_back(static_cast<Index>(found - stored.input_index.begin()));
        }
    }
    return result;
}

/// How far storing moved a vertex at most: not at all, or by rounding to single. Vertices that vanished in
/// the rounded hull lie in it.
double moved_by(const Polyhedron& given, const Polyhedron& stored, const Mat3d& rotation) {
    if (given.vertices == stored.vertices) return 0;
    std::vector<Vec3d> rounded;
    for (const Vec3d& v : given.vertices) rounded.push_back(to_single(v));
    return representation_error(given.vertices, rounded, rotation);
}

}  // namespace

Result<Certificates> certificates_of(const NamedAnswer& answer, const Query& query,
                                     std::span<const Polyhedron> given, std::span<const Polyhedron> stored) {
    const Polyhedron& a = stored[query.body_a];
    const Polyhedron& b = stored[query.body_b];
    const bool apart = answer.distance.status == Status::separated;
    const std::vector<Index> on_a = apart ? stored_vertices(a, answer.feature_a) : answer.proof_a;
    const std::vector<Index> on_b = apart ? stored_vertices(b, answer.feature_b) : answer.proof_b;
    const Vec3d along = apart ? Vec3d(answer.distance.point_b - answer.distance.point_a) : answer.normal;
    const auto held = certify(a.vertices, query.pose_a, b.vertices, query.pose_b, {on_a}, {on_b}, along);
    if (!held) return Result<Certificates>::failure(held.error);
    const double moved_a = moved_by(given[query.body_a], a, query.pose_a.rotation);
    const double moved_b = moved_by(given[query.body_b], b, query.pose_b.rotation);
    return Result<Certificates>::success({*held, widen(*held, moved_a, moved_b)});
}

}  // namespace edgewise
