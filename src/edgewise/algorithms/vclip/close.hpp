// SPDX-License-Identifier: MIT
//
// Close features whose distance rounding may have got wrong.
//
// The line between the closest points is a difference of two points, each rounded: its direction is off by
// that rounding over its length. Where an edge of each body lies almost along the other's, or a face along an
// edge, whole valleys of feature pairs have almost the same distance, and V-Clip may stop anywhere in them.
// A vertex over a face, and edges that cross at a fair angle, are safe: there a plane or a cross product says
// which way is out, whatever the distance.
#pragma once

#include <algorithm>
#include <type_traits>

#include "edgewise/algorithms/vclip/body.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::vclip {

/// Times the size: below this distance the direction between closest points cannot be trusted.
template <class TableA, class TableB>
inline constexpr double untrusted =
    rounded_planes<TableA> || rounded_planes<TableB> ? close_of_rounded_planes
                                                     : double{Tolerance<ComputeOf<TableA>>::close};

/// Times the size: below this distance even the signs of V-Clip's tests are in doubt, on any features.
template <class Table>
inline constexpr double hardly_apart{Tolerance<ComputeOf<Table>>::hardly_apart};

/// True unless the pair's own geometry says, in full precision, which way is out.
template <class TableA, class TableB>
[[nodiscard]] bool may_slide(const Body<TableA>& a, const Body<TableB>& b) {
    using enum FeatureKind;
    if (rounded_planes<TableA> || rounded_planes<TableB>) return true;
    if (a.feature.kind() == face || b.feature.kind() == face) return false;
    if (a.feature.kind() == vertex || b.feature.kind() == vertex) return true;
    using Scalar = ComputeOf<TableA>;
    const auto p = a.table.direction(a.feature.edge());
    const auto q = a.from_other.direction(b.table.direction(b.feature.edge()));
    const Scalar fair = Tolerance<Scalar>::fair_crossing * squared_norm(p) * squared_norm(q);
    return !(squared_norm(cross(p, q)) >= fair);
}

}  // namespace edgewise::vclip
