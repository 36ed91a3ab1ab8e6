// SPDX-License-Identifier: MIT
#include "edgewise/bench/certificates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "edgewise/geometry/message.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::bench {

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

/// How far a point lies from the stored body, rounded upward.
double outside(const Vec3d& point, const Polyhedron& stored, const Pose& pose) {
    const auto exact = truth::exact_distance(std::vector{point}, pose, stored.vertices, pose);
    const double infinity = std::numeric_limits<double>::infinity();
    if (!exact) return infinity;
    return exact->distance == 0 ? 0 : std::nextafter(exact->distance, infinity);
}

/// Bound of the distance of the stored body from the given one: how far storing moved a vertex, or points
/// left out by hulls stick out (some 1e-12 of the extent, as flat; more after coarse rounding).
double moved_by(const Polyhedron& given, std::span<const Vec3d> points, const Polyhedron& stored,
                const Mat3d& rotation) {
    std::map<Index, Vec3d> kept;
    for (std::size_t i = 0; i < stored.vertex_count(); ++i) kept[stored.input_index[i]] = stored.vertices[i];
    std::vector<Vec3d> from, to;
    double farthest = 0;
    const auto see = [&](Index name, const Vec3d& v) {
        const auto found = kept.find(name);
        if (found == kept.end()) {
            farthest = std::max(farthest, outside(v, stored, {rotation, Vec3d::Zero()}));
        } else if (found->second != v) {
            from.push_back(v);
            to.push_back(found->second);
        }
    };
    for (std::size_t i = 0; i < points.size(); ++i) see(static_cast<Index>(i), points[i]);
    if (points.empty()) {  // the vertices are all that is known; else they are among the points
        for (std::size_t i = 0; i < given.vertex_count(); ++i) see(given.input_index[i], given.vertices[i]);
    }
    return std::max(farthest, from.empty() ? 0 : truth::representation_error(from, to, rotation));
}

}  // namespace

Result<Certificates> certificates_of(const NamedAnswer& answer, const scene::Query& query,
                                     std::span<const Polyhedron> given, std::span<const Polyhedron> stored,
                                     std::span<const Vec3d> points_a, std::span<const Vec3d> points_b) {
    if (answer.distance.status == Status::failed)
        return Result<Certificates>::failure("the query failed: no answer to certify");
    const Polyhedron& a = stored[query.body_a];
    const Polyhedron& b = stored[query.body_b];
    const bool separated = answer.proof_a.empty();
    const std::vector<Index> on_a = separated ? stored_vertices(a, answer.feature_a) : answer.proof_a;
    const std::vector<Index> on_b = separated ? stored_vertices(b, answer.feature_b) : answer.proof_b;
    const Vec3d along = separated ? Vec3d(answer.distance.point_b - answer.distance.point_a) : answer.normal;
    const auto held = truth::certify(a.vertices, query.pose_a, b.vertices, query.pose_b, on_a, on_b, along);
    if (!held) return Result<Certificates>::failure(held.error);
    const double moved_a = moved_by(given[query.body_a], points_a, a, query.pose_a.rotation);
    const double moved_b = moved_by(given[query.body_b], points_b, b, query.pose_b.rotation);
    return Result<Certificates>::success({*held, truth::widen(*held, moved_a, moved_b)});
}

std::string contradiction(double distance, const truth::Certificate& certificate, double too_short,
                          double too_long) {
    // Written so that NaN is outside.
    if (distance >= certificate.lower - too_short && distance <= certificate.upper + too_long) return {};
    return message("the distance found, ", distance, ", contradicts its own certificate [", certificate.lower,
                   ", ", certificate.upper, "]");
}

}  // namespace edgewise::bench
