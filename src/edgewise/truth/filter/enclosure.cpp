// SPDX-License-Identifier: MIT
//
// The origin's barycentric coordinates are the volumes +[123], -[023], +[013], -[012] over their sum: inside
// means that all four have one sign. Corners off by e move a volume of corners no longer than l by at most
// 3 e l^2 + 3 e^2 l + e^3; its own rounding is below 10u l^3 (three minors of 3u, a dot product of 3u).
#include "edgewise/truth/filter/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/filter/float_proof.hpp"

namespace edgewise::truth {

bool surely_encloses_origin(const std::array<Vec3d, 4>& p, double error) {
    double longest = 0;
    for (const Vec3d& corner : p) longest = std::max(longest, norm(corner));
    const double reach = (longest + error) * (1 + 16 * proof_rounding);
    const double bound =
        (3 * error + 10 * proof_rounding * reach) * reach * reach + (3 * reach + error) * error * error;
    const double certain = bound * (1 + 16 * proof_rounding);
    const Vec3d c01 = cross(p[0], p[1]), c23 = cross(p[2], p[3]);
    const std::array<double, 4> volume = {dot(p[1], c23), -dot(p[0], c23), dot(c01, p[3]), -dot(c01, p[2])};
    const bool all_above = std::ranges::all_of(volume, [&](double v) { return v > certain; });
    const bool all_below = std::ranges::all_of(volume, [&](double v) { return v < -certain; });
    return all_above || all_below;
}

namespace {

/// A point to either side of a triangle around the origin: the line between the two leaves the origin in one
/// of the tetrahedra that it makes with the triangle's sides.
bool encloses_beside_triangle(PosedPair& pair, const std::array<Vec3d, 4>& p) {
    const Vec3d normal = cross(Vec3d(p[1] - p[0]), Vec3d(p[2] - p[0]));
    const double length = norm(normal);
    if (!(length > 0)) return false;
    const Vec3d below = pair.lowest(normal / length).point, above = pair.lowest(normal / -length).point;
    const double error = pair.point_error();
    return surely_encloses_origin({p[0], p[1], below, above}, error) ||
           surely_encloses_origin({p[1], p[2], below, above}, error) ||
           surely_encloses_origin({p[2], p[0], below, above}, error);
}

/// Three points around a segment through the origin, and either of its ends.
bool encloses_around_segment(PosedPair& pair, const std::array<Vec3d, 4>& p) {
    const Vec3d along = p[1] - p[0];
    const double length = norm(along);
    if (!(length > 0)) return false;
    const Vec3d axis = along / length;
    const Vec3d side = cross(axis, std::abs(axis.x()) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0));
    const Vec3d other = cross(axis, side);
    const Vec3d first = pair.lowest(side).point, second = pair.lowest(other - 0.5 * side).point,
                third = pair.lowest(-other - 0.5 * side).point;
    const double error = pair.point_error();
    return surely_encloses_origin({p[0], first, second, third}, error) ||
           surely_encloses_origin({p[1], first, second, third}, error);
}

}  // namespace

bool encloses_with_more(PosedPair& pair, const MinimumSimplex<Vec3d>& simplex) {
    if (simplex.size == 3) return encloses_beside_triangle(pair, simplex.point);
    if (simplex.size == 2) return encloses_around_segment(pair, simplex.point);
    return false;
}

// Two more proofs of contact, for pairs where every tetrahedron has the origin on a face.

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
