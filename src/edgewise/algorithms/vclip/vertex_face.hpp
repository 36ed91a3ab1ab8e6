// SPDX-License-Identifier: MIT
//
// State V-F (TR-97-05, Algorithms 6 and 3). The vertex must lie in the face's prism, none of its edges may
// lead towards the face's plane, and it must lie above; below, the search is in a local minimum and escapes
// over all faces.
//
// Departures: the report's test |D(V)| > |D(V')| is wrong for a vertex above and a neighbour farther below;
// signed slopes are compared instead. The steepest edge is taken, and only if it is steeper than rounding
// noise (tolerance.hpp, towards_plane): a noise edge under the face would skip the escape and loop.
#pragma once

#include <algorithm>

#include "edgewise/algorithms/vclip/body.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::vclip {

/// Moves `mine` from its vertex to the steepest edge towards the plane of the other body's face, which lies
/// at signed `height` below it and has this normal, both of any scale; false if every edge leads away.
template <class Table>
[[nodiscard]] bool approach_plane(Body<Table>& mine, const Vec3<ComputeOf<Table>>& normal,
                                  ComputeOf<Table> height) {
    using Scalar = ComputeOf<Table>;
    const Vec3<Scalar> towards = height > 0 ? normal : Vec3<Scalar>(-normal);
    const auto descent =
        steepest_descent(mine.table, mine.feature.vertex(), mine.from_other.direction(towards));
    constexpr Scalar level = Tolerance<Scalar>::towards_plane * Tolerance<Scalar>::towards_plane;
    if (!descent.edge || -descent.slope <= level * descent.steepest) return false;
    mine.move_to_edge(*descent.edge);
    return true;
}

/// Finds the face with the plane that the point is highest above (TR-97-05, Algorithm 3): either a better
/// face to continue with, or proof that the point lies inside.
template <class Table>
[[nodiscard]] [[gnu::noinline]] Step escape_local_minimum(Body<Table>& body,
                                                          const Vec3<ComputeOf<Table>>& point) {
    auto best = body.feature.face();
    auto highest = body.table.face_plane(best).distance(point);
    for (const auto f : body.table.all_faces()) {
        const auto height = body.table.face_plane(f).distance(point);
        if (height > highest) {
            highest = height;
            best = f;
        }
    }
    const auto noise = std::max(plane_noise<Table> * max_abs(point), face_noise(body.table));
    if (highest < -noise) return Step::overlapping;
    if (highest <= 0) return Step::touching;
    body.move_to_face(best);
    return Step::escaped;
}

template <class Mine, class Theirs>
[[nodiscard]] Step vertex_face(Body<Mine>& mine, Body<Theirs>& theirs) {
    const auto face = theirs.feature.face();
    const auto point = theirs.from_other.point(mine.table.vertex(mine.feature.vertex()));
    if (const auto side = most_violated_face_side(theirs.table, face, point)) {
        theirs.move_to_edge(*side);
        return Step::moved;
    }
    const auto plane = unscaled_face_plane(theirs.table, face);
    const auto height = plane.distance(point);
    if (approach_plane(mine, Vec3<ComputeOf<Mine>>(plane.normal), height)) return Step::moved;
    return height > 0 ? Step::separated : escape_local_minimum(theirs, point);
}

}  // namespace edgewise::vclip
