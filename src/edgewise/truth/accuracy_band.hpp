// SPDX-License-Identifier: MIT
//
// How near to contact a pair must be for its verdict to be a matter of rounding.
//
//     scale  = max(extent A, extent B, |offset|)
//     extent = diagonal of the vertex box, in the body's frame
//     offset = max(|t_B - t_A|, largest |v| of A and B): what a query in the frame of one body has to carry
//     band   = 16 eps scale + 4 ortho_error max(extent), eps = 2^-52, or 2^-23 where single computes
//
// The translations count by their difference only: queries subtract them first, in double. ortho_error is
// that of the worse of the two rotations: code that uses R_A^T R_B may differ by it from R v + t as given.
#pragma once

#include <algorithm>
#include <span>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::truth {

struct AccuracyBand {
    double scale = 0;
    double band = 0;

    /// An error divided by the scale; 0 for two points at one place that were found there.
    [[nodiscard]] double over_scale(double error) const { return error == 0 ? 0 : error / scale; }
    /// An error divided by the scale, less what the band excuses; NaN stays NaN.
    [[nodiscard]] double beyond(double error) const {
        const double rest = error - band;
        return rest <= 0 ? 0 : rest / (scale > 0 ? scale : 1);
    }
};

/// Size of a body as the band needs it: the largest |v|, and the diagonal of the box of its vertices.
struct BodySize {
    double reach = 0, extent = 0;
};

/// Returns the band of two bodies of known size, at any poses. ortho_error: that of the worse rotation.
[[nodiscard]] inline AccuracyBand accuracy_band(const BodySize& a, const BodySize& b, double offset,
                                                double ortho_error, double eps) {
    const double largest_extent = std::max(a.extent, b.extent);
    AccuracyBand result;
    result.scale = std::max({largest_extent, offset, a.reach, b.reach});
    result.band = verdict_band_steps * eps * result.scale + verdict_band_ortho * ortho_error * largest_extent;
    return result;
}

[[nodiscard]] inline double reach(std::span<const Vec3d> points) {
    double largest = 0;
    for (const Vec3d& p : points) largest = std::max(largest, norm(p));
    return largest;
}

/// eps: Tolerance<Compute>::eps.
[[nodiscard]] inline AccuracyBand accuracy_band(std::span<const Vec3d> a, const Pose& pose_a,
                                                std::span<const Vec3d> b, const Pose& pose_b, double eps) {
    const double apart = norm(Vec3d(pose_b.translation - pose_a.translation));
    const double ortho = std::max(ortho_error(pose_a.rotation), ortho_error(pose_b.rotation));
    return accuracy_band(BodySize{reach(a), extent(a)}, BodySize{reach(b), extent(b)}, apart, ortho, eps);
}

}  // namespace edgewise::truth
