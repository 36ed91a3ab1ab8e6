// SPDX-License-Identifier: MIT
//
// A body's own grid: 65 535 steps over its box, the same along all axes, a power of two wide, so that a place
// on the grid is an exact number. Storing a vertex on it moves each coordinate by half a step at most.
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

    Grid() = default;
    /// Of the points' box. No step is finer than `eps` of the largest coordinate, so that what computes with
    /// this rounding step holds every place exactly.
    Grid(std::span<const Vec3d> points, double eps);

    [[nodiscard]] Place nearest(const Vec3d& point) const;
    [[nodiscard]] Vec3d at(const Place& place) const {
        return low + step * Vec3d(place[0], place[1], place[2]);
    }
};

/// The body that a table on this grid really holds: the hull of its vertices moved to their nearest places.
[[nodiscard]] Result<Polyhedron> round_to_grid(const Polyhedron& body, double eps);

/// Likewise, but a body that contains the given one: grown about its middle, by no more than is needed,
/// before it is rounded. Flat bodies stay flat, and are contained but for half a step across.
[[nodiscard]] Result<Polyhedron> round_to_grid_outward(const Polyhedron& body, double eps);

}  // namespace edgewise
