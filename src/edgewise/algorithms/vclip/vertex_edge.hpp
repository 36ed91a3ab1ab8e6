// SPDX-License-Identifier: MIT
//
// State V-E (TR-97-05, Algorithm 5). Tests first the vertex against the edge's four planes, vertex-edge
// planes before edge-face planes; then clips the edge to the vertex's region, with the derivative test at the
// rest of the edge.
#pragma once

#include <optional>

#include <cassert>

#include "edgewise/algorithms/vclip/body.hpp"
#include "edgewise/algorithms/vclip/clip.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::vclip {

/// Moves `body` from its edge to the neighbour on the point's side; false if inside the edge's region.
template <class Table>
[[nodiscard]] bool leave_edge_region(Body<Table>& body, const Vec3<ComputeOf<Table>>& point) {
    const Table& table = body.table;
    const auto e = body.feature.edge();
    if (table.vertex_edge_plane(e, End::tail).distance(point) > 0) {
        body.move_to_vertex(table.tail(e));
        return true;
    }
    if (table.vertex_edge_plane(e, End::head).distance(point) > 0) {
        body.move_to_vertex(table.head(e));
        return true;
    }
    const auto left = table.edge_face_plane(e, Side::left).distance(point);
    const auto right = table.edge_face_plane(e, Side::right).distance(point);
    if (!(left > 0) && !(right > 0)) return false;
    body.move_to_face(left >= right ? table.left(e) : table.right(e));
    return true;
}

/// A boundary at a vertex: the plane between its region and that of an edge.
template <class Table>
struct VertexSide {
    typename RingNameOf<Table>::Type edge;
    Vec3<ComputeOf<Table>> normal;
};

/// The other body's edge, clipped to the region of a vertex.
template <class Table>
struct ClippedByVertex {
    std::optional<VertexSide<Table>> excluding;  ///< set if nothing is left on this side of it
    Clip<ComputeOf<Table>, VertexSide<Table>> rest;
};

template <class Table>
[[nodiscard]] ClippedByVertex<Table> clip_to_vertex_region(const Body<Table>& body,
                                                           const Segment<ComputeOf<Table>>& segment) {
    ClippedByVertex<Table> clipped;
    visit_vertex_planes(body.table, body.feature.vertex(), [&](const auto& edge, const auto& plane) {
        const VertexSide<Table> side{edge, plane.normal};
        const auto left =
            clipped.rest.against(plane.distance(segment.tail), plane.distance(segment.head), side);
        if (left == Clipped::simply_excluded) clipped.excluding = side;
        return !clipped.excluding;
    });
    return clipped;
}

/// Moves `mine` from its vertex when the other body's edge, which holds the vertex in its region, leaves the
/// vertex's own region before it comes closest.
template <class Mine, class Theirs>
[[nodiscard]] bool leave_vertex_by_clipping(Body<Mine>& mine, const Body<Theirs>& theirs) {
    using Scalar = ComputeOf<Mine>;
    const auto name = mine.feature.vertex();
    const auto segment = segment_seen_by(mine, theirs.table, theirs.feature.edge());
    const auto [excluding, clip] = clip_to_vertex_region(mine, segment);
    const auto move_to = [&](const VertexSide<Mine>& side) {
        mine.move_to_edge(edge_in_ring(mine.table, name, side.edge));
        return true;
    };
    if (excluding) return move_to(*excluding);
    if (!clip.at_low && !clip.at_high) return false;
    assert((clip.low <= clip.high || (clip.at_low && clip.at_high)) && "two planes leave nothing, not one");

    const Vec3<Scalar> vertex = mine.table.vertex(name), along = segment.head - segment.tail;
    if (clip.low > clip.high) {  // nothing is left: it must move, to the worse side
        const Scalar closest = projection(segment.tail, along, vertex);
        return move_to(clip.low - closest >= closest - clip.high ? *clip.at_low : *clip.at_high);
    }
    const auto slope_at = [&](Scalar lambda, const VertexSide<Mine>& side) {
        return slope_where_clipped(along, side.normal, Vec3<Scalar>(segment.at(lambda) - vertex));
    };
    if (clip.at_low && slope_at(clip.low, *clip.at_low) > 0) return move_to(*clip.at_low);
    if (clip.at_high && slope_at(clip.high, *clip.at_high) < 0) return move_to(*clip.at_high);
    return false;
}

template <class Mine, class Theirs>
[[nodiscard]] Step vertex_edge(Body<Mine>& mine, Body<Theirs>& theirs) {
    const auto point = theirs.from_other.point(mine.table.vertex(mine.feature.vertex()));
    if (leave_edge_region(theirs, point)) return Step::moved;
    if (leave_vertex_by_clipping(mine, theirs)) return Step::moved;
    return Step::separated;
}

}  // namespace edgewise::vclip
