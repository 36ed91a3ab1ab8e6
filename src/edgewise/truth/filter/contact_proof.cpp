// SPDX-License-Identifier: MIT
#include "edgewise/truth/filter/contact_proof.hpp"

#include <algorithm>
#include <vector>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/filter/float_proof.hpp"

namespace edgewise::truth {

namespace {

/// Relative to the smaller extent: enough to distinguish directions, and the nearest features stay.
constexpr double nudge = 1.0 / 64;

/// Relative to the smaller extent: no symmetry of a body has such a point in a plane of its vertices.
const Vec3d off_centre(0.0137, -0.0213, 0.0091);

double smaller_extent(const PosedPair& pair) { return std::min(pair.a().extent(), pair.b().extent()); }

Vec3d centre_in_world(const ScannedBody& body, const Pose& pose) { return pose.apply(body.centre()); }

/// Strictly inside a tetrahedron of the body's vertices.
bool is_surely_inside(ScannedBody& body, const Pose& pose, const Vec3d& point) {
    static const std::vector<Vec3d> origin = {Vec3d::Zero()};
    ScannedBody scanned(origin);
    const Pose there{Mat3d::Identity(), point};
    PosedPair pair(body, pose, scanned, there);
    return search_distance(pair, 0).verdict == FloatVerdict::overlapping;
}

}  // namespace

Vec3d nudged_separation(PosedPair& pair) {
    const Vec3d apart = centre_in_world(pair.b(), pair.pose_b()) - centre_in_world(pair.a(), pair.pose_a());
    const double length = norm(apart);
    const Vec3d away = length > 0 ? Vec3d(apart / length) : Vec3d(Vec3d::UnitX());
    Pose moved = pair.pose_b();
    moved.translation += away * (nudge * smaller_extent(pair));
    PosedPair nudged(pair.a(), pair.pose_a(), pair.b(), moved);
    const FloatProof found = search_distance(nudged, Tolerance<double>::eps * pair.span());
    return found.lower > 0 ? found.separation : Vec3d(Vec3d::Zero());
}

bool share_a_point(PosedPair& pair) {
    const Vec3d halfway =
        (centre_in_world(pair.a(), pair.pose_a()) + centre_in_world(pair.b(), pair.pose_b())) / 2;
    const Vec3d point = halfway + off_centre * smaller_extent(pair);
    return is_surely_inside(pair.a(), pair.pose_a(), point) &&
           is_surely_inside(pair.b(), pair.pose_b(), point);
}

}  // namespace edgewise::truth
