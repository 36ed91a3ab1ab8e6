// SPDX-License-Identifier: MIT
//
// Hulls of point sets that are no solid: a polygon (with a front and a back), a segment, a point. One rule
// says what is flat, for all of Edgewise: what is thinner than flat_thickness (tolerance.hpp) of its extent.
#pragma once

#include <span>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/result.hpp"

namespace edgewise {

/// The hull of points that are flat by that rule. Fails, with a reason, on an empty set, NaN, infinity or
/// coordinates out of range.
[[nodiscard]] Result<Polyhedron> flat_hull(std::span<const Vec3d> points);

/// The hull of any points: convex_hull of a solid, flat_hull of what is none.
[[nodiscard]] Result<Polyhedron> hull_of_any(std::span<const Vec3d> points);

}  // namespace edgewise
