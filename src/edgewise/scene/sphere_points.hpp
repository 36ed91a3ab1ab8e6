// SPDX-License-Identifier: MIT
//
// Points of the triangulated spheres: two families of any resolution k, one point per grid node.
//   octahedral  4 k^2 + 2 points: nodes of the octahedron |x| + |y| + |z| = k, pushed out to the sphere
//   cubic       6 k^2 + 2 points: nodes of the surface of a k x k x k cube, spread by square roots only
// No size is in both: 4 a^2 = 6 b^2 has no whole solution. sphere38 is octahedral, k = 3; sphere386 cubic, k
// = 8.
//
// On the exact sphere many quads of neighbours are coplanar, and a hull would have faces of more than three
// sides. So every radius is moved by a seeded amount of at most 1/16 of the squared grid spacing. A vertex
// lies about half the squared spacing above the plane of its neighbours: all stay extreme, no quad stays
// flat (the flattest edge of sphere386 folds by 6e-5 rad, that of sphere24578 by 3e-7).
//
// Coordinates are whole multiples of 2^-21 below 1.25, and still exact in single precision after
// multiplication by 3/4, 5/4 or 3/2: tables of every precision hold the same body.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "edgewise/geometry/vec.hpp"

namespace edgewise::scene {

enum class SphereFamily : std::uint8_t { octahedral, cubic };

struct SphereSize {
    SphereFamily family;
    int k;  ///< grid steps along a quarter turn

    [[nodiscard]] std::size_t vertices() const {
        const std::size_t square = static_cast<std::size_t>(k) * static_cast<std::size_t>(k);
        return (family == SphereFamily::octahedral ? 4 : 6) * square + 2;
    }
};

/// Above this many vertices the radius noise would drown in the coordinate grid.
inline constexpr std::size_t largest_sphere = 100000;

/// Every member of both families up to largest_sphere, smallest first.
[[nodiscard]] std::vector<SphereSize> sphere_sizes();

[[nodiscard]] std::vector<Vec3d> sphere_points(SphereSize size);

/// A sphere of meridians and parallels with 386 vertices: two poles and 24 parallels of 16 points, on the
/// same grid of coordinates, radii moved a little so that no quad is flat. Given ring by ring, neighbours
/// across rings are 16 vertices apart in memory, and the poles have 16 neighbours each; the other spheres are
/// given slice by slice, with few neighbours everywhere.
[[nodiscard]] std::vector<Vec3d> uv_sphere_points();

}  // namespace edgewise::scene
