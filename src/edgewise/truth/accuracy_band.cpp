// SPDX-License-Identifier: MIT
//
// The factors are in geometry/tolerance.hpp.
#include "edgewise/truth/accuracy_band.hpp"

#include <algorithm>
#include <cmath>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::truth {

namespace {

double reach(std::span<const Vec3d> points) {
    double largest = 0;
    for (const Vec3d& p : points) largest = std::max(largest, norm(p));
    return largest;
}

}  // namespace

AccuracyBand accuracy_band(const BodySize& a, const BodySize& b, double offset, double ortho_error,
                           double eps) {
    const double largest_extent = std::max(a.extent, b.extent);
    AccuracyBand result;
    result.scale = std::max({largest_extent, offset, a.reach, b.reach});
    result.band = verdict_band_steps * eps * result.scale + verdict_band_ortho * ortho_error * largest_extent;
    return result;
}

AccuracyBand accuracy_band(std::span<const Vec3d> a, const Pose& pose_a, std::span<const Vec3d> b,
                           const Pose& pose_b, double eps) {
    const double apart = norm(Vec3d(pose_b.translation - pose_a.translation));
    const double ortho = std::max(ortho_error(pose_a.rotation), ortho_error(pose_b.rotation));
    return accuracy_band(BodySize{reach(a), extent(a)}, BodySize{reach(b), extent(b)}, apart, ortho, eps);
}

}  // namespace edgewise::truth
