// SPDX-License-Identifier: MIT
//
// A body's own grid: the same step along all axes, a power of two, so that a place on the grid is an exact
// number. The longest side of the body's box takes from 32 767 to 65 535 steps (half of what 16 bits hold is
// lost at worst, because a step is a power of two), fewer where the body lies so far out that its coordinates
// hold no finer ones. Storing a vertex moves each coordinate by half a step at most.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/result.hpp"

namespace edgewise {

struct Grid {
    using Place = std::array<std::uint16_t, 3>;

    Vec3d low = Vec3d::Zero();  ///< of the box, rounded down to a step
    double step = 1;

    /// Grid for points that are still to be rounded. A step is wider than 2 `eps` of the largest coordinate,
    /// so that arithmetic with this rounding step holds every place exactly.
    [[nodiscard]] static Grid for_rounding(std::span<const Vec3d> points, double eps);

    /// Grid for points that were rounded: every point is exactly a place, although rounding may have made
    /// their box a step longer. It is as fine as the grid that they were rounded to, or finer.
    [[nodiscard]] static Grid of_rounded(std::span<const Vec3d> points, double eps);

    [[nodiscard]] Place nearest(const Vec3d& point) const;
    [[nodiscard]] Vec3d at(const Place& place) const {
        return low + step * Vec3d(place[0], place[1], place[2]);
    }
};

/// The body that a table on its grid really holds: the hull of its vertices moved to their nearest places. A
/// body that is on its grid is returned as it is.
[[nodiscard]] Result<Polyhedron> round_to_grid(const Polyhedron& body, double eps);

/// A rounded body that contains the given one: it is grown about its middle before it is rounded, step by
/// step, until every vertex is a vertex of the result or inside it by more than rounding. A body so thin that
/// growing widens it less than rounding may narrow it becomes the hull of boxes around its vertices, two
/// steps to each side. A body on its grid is returned unchanged. Flat bodies are rounded as in round_to_grid,
/// and are not contained.
[[nodiscard]] Result<Polyhedron> round_to_grid_outward(const Polyhedron& body, double eps);

}  // namespace edgewise
