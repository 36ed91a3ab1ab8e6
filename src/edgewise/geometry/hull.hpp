// SPDX-License-Identifier: MIT
//
// From any point set, or from faces given by the user, to the canonical Polyhedron. Hulls by Qhull, with
// merged coplanar facets kept as one face; coordinates are recentred and scaled by exact steps before Qhull
// sees them. A body's vertices are always the very doubles of the input.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/result.hpp"

namespace edgewise {

/// Convex hull of a point set. Points that stick out by no more than rounding (face_planarity x extent) may
/// be left out. Fails, with a reason, on too few points, flat or collinear sets (thinner than flat_thickness
/// x extent), duplicates only, NaN or infinity, and coordinates out of range.
[[nodiscard]] Result<Polyhedron> convex_hull(std::span<const Vec3d> points);

/// The hull of points that have no volume: a polygon (with a front and a back), a segment, a point. One rule
/// says what is flat, for all of Edgewise: thinner than flat_thickness (tolerance.hpp) of its extent. Fails,
/// with a reason, on an empty set, NaN, infinity or coordinates out of range.
[[nodiscard]] Result<Polyhedron> flat_hull(std::span<const Vec3d> points);

/// The hull of any points: convex_hull of a solid, else flat_hull.
[[nodiscard]] Result<Polyhedron> hull_of_any(std::span<const Vec3d> points);

/// A body with faces taken as given: each face is a counter-clockwise ring (seen from outside) of vertex
/// indices. Coplanar neighbours are not merged; a body wound inward throughout is reversed; vertices in no
/// face are left out, with a warning. Fails, with a reason, if the faces do not bound a closed convex solid,
/// are not planar to face_planarity x extent (if bent by no more than single precision does, the hull of
/// their vertices is taken, with a warning), have no area, or have vertices in the middle of edges.
[[nodiscard]] Result<Polyhedron> polyhedron_from_faces(std::span<const Vec3d> points,
                                                       std::span<const std::vector<Index>> faces);

/// The body after its vertices moved (`moved`: one place each, in order): the hull of the new places, with
/// its own topology. `input_index` still names vertices of the original input. Returns the body unchanged
/// when none moved; a warning says how many vertices vanish. `where` ends messages: "single precision".
[[nodiscard]] Result<Polyhedron> hull_of_moved(const Polyhedron& body, std::span<const Vec3d> moved,
                                               const char* where);

/// Empty; else which coordinate of the body is too large for single precision, and what to do.
[[nodiscard]] std::string single_range_error(const Polyhedron& body);

/// The body that a table with single-precision storage really holds: the hull of the rounded vertices, with
/// its own topology. `input_index` still names the vertices of the original input. Returns the body unchanged
/// when every coordinate is exactly representable; a warning says how many vertices vanish.
[[nodiscard]] Result<Polyhedron> round_to_single(const Polyhedron& body);

/// Returns the double nearest to x that single precision holds; infinite beyond its range. The volatile keeps
/// each value scalar: from -O2 on, GCC 12's straight-line vectoriser takes double -> float -> double of two
/// neighbours for no operation and drops it. Never write the two casts next to each other.
[[nodiscard]] inline double to_single(double x) {
    const volatile float single = static_cast<float>(x);
    return static_cast<double>(single);
}

[[nodiscard]] inline Vec3d to_single(const Vec3d& v) {
    return {to_single(v.x()), to_single(v.y()), to_single(v.z())};
}

}  // namespace edgewise
