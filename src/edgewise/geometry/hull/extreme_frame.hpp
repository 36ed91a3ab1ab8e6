// SPDX-License-Identifier: MIT
//
// The tetrahedron of extreme points: the ends of the longest axis, the point farthest from their line, the
// point farthest from the plane of the first three. It measures how thick a point set is (within a small
// factor of its true width), and gives thin sets axes of their own.
#pragma once

#include <span>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

struct ExtremeFrame {
    Vec3d origin;  ///< one of the points
    Mat3d axes;    ///< rows: along the longest axis, across it in the widest plane, normal to that plane
    double across_line;  ///< distance of the third point from the line of the first two, longest axis = 1
    double
        across_plane;  ///< distance of the fourth point from the plane of the first three, longest axis = 1
};

/// `chosen`: indices of at least two distinct points.
[[nodiscard]] ExtremeFrame extreme_frame(std::span<const Vec3d> points, std::span<const Index> chosen);

/// The chosen points in the frame's axes, each axis scaled by a power of two to an extent of about 1: a thin
/// body becomes a round one. One rounding a coordinate, after scaling, so that the thin direction keeps its
/// digits.
[[nodiscard]] std::vector<Vec3d> in_own_axes(std::span<const Vec3d> points, std::span<const Index> chosen);

}  // namespace edgewise
