// SPDX-License-Identifier: MIT
//
// Proves an answer without Voronoi planes: the planes through the two witness points, across the line
// between them, must have one body on either side. Used only for bodies with flat edges or vertices in the
// middle of a side (geometry/strictly_convex.hpp): the Voronoi region of such a feature continues under
// the surface, and a point deep inside the body, or behind it, looks as if it were closest to that
// feature.
#pragma once

#include <algorithm>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/algorithms/vclip/body.hpp"

namespace edgewise::vclip {

/// Returns a vertex of the feature: the start of the search for a vertex that lies farther.
template <class Table>
[[nodiscard]] typename Table::Vertex vertex_on(const Body<Table>& body) {
    switch (body.feature.kind()) {
        case FeatureKind::vertex:
            return body.feature.vertex();
        case FeatureKind::edge:
            return body.table.tail(body.feature.edge());
        case FeatureKind::face:
            break;
    }
    return body.table.tail((*body.table.ring_of_face(body.feature.face()).begin()).edge);
}

/// Returns true if no vertex lies farther along the direction (any length) than the point; both in the body's
/// frame. The direction is a difference of rounded points, so the noise is that of a point times the size,
/// however short the direction; a feature that holds from the wrong side fails by the direction's length
/// times the size. The storage of planes does not matter here: none is read. A face needs no check: its state
/// found the other body's vertex above it, so the body lies below.
template <class Table>
[[nodiscard]] bool ends_at(const Body<Table>& body, const Vec3<ComputeOf<Table>>& point,
                           const Vec3<ComputeOf<Table>>& direction) {
    using Scalar = ComputeOf<Table>;
    if (body.feature.kind() == FeatureKind::face && may_climb(body.table)) return true;
    const auto farthest = support(body.table, direction, vertex_on(body));
    const Scalar size = std::max({max_abs(farthest.point), max_abs(point), max_abs(direction)});
    return dot(Vec3<Scalar>(farthest.point - point), direction) <=
           Tolerance<Scalar>::contact_noise * size * size;
}

/// Returns true if the bodies are separated by the answer's distance. Witness points are in A's frame.
template <class TableA, class TableB>
[[nodiscard]] [[gnu::noinline]] bool is_proven(const Distance& result, const Body<TableA>& a,
                                               const Body<TableB>& b) {
    using Scalar = ComputeOf<TableA>;
    const Vec3<Scalar> on_a = result.point_a.template cast<Scalar>();
    const Vec3<Scalar> on_b = result.point_b.template cast<Scalar>();
    const Vec3<Scalar> between = on_b - on_a;
    return ends_at(a, on_a, between) &&
           ends_at(b, b.from_other.point(on_b), Vec3<Scalar>(-b.from_other.direction(between)));
}

}  // namespace edgewise::vclip
