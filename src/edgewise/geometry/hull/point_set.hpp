// SPDX-License-Identifier: MIT
//
// A point set before its hull is made: checks the coordinates, finds the distinct points, moves the set near
// the origin at unit size, and says if it is a solid at all. Recentring and scaling are exact, so no decision
// depends on where a body lies or how large it is.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

/// Returns an empty text, or one line naming the first vertex that is not finite or out of range.
[[nodiscard]] std::string coordinate_error(std::span<const Vec3d> points);

/// Longest side of the box around the points.
[[nodiscard]] double widest_extent(std::span<const Vec3d> points);

/// Returns for each point the lowest index that has the same coordinates.
[[nodiscard]] std::vector<Index> first_of_equals(std::span<const Vec3d> points);

/// Returns one index for each distinct point, in the order of their coordinates (so that a hull does not
/// depend on the order of the input).
[[nodiscard]] std::vector<Index> distinct_points(std::span<const Vec3d> points);

/// The power of two that takes a positive size to [1/2, 1); 1 for size 0.
[[nodiscard]] double scale_to_unit(double size);

/// The power of two that takes the largest extent of the points to [1/2, 1); 1 when all are equal.
[[nodiscard]] double unit_scale(std::span<const Vec3d> points);

/// The chosen points, moved near the origin where that is exact and each axis scaled by its own power of two
/// to an extent of about 1. Such a map changes neither the hull's vertices nor its faces.
[[nodiscard]] std::vector<Vec3d> normalised(std::span<const Vec3d> points, std::span<const Index> chosen);

/// Empty, or the reason why these points have no solid hull: too few, all equal, on a line, in a plane.
[[nodiscard]] std::string flatness_error(std::span<const Vec3d> points, std::span<const Index> distinct);

}  // namespace edgewise
