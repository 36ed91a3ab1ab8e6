// SPDX-License-Identifier: MIT
//
// Questions about a whole ring, with a generic answer. A layout that can answer in one vectorised pass
// defines a member of the same name; it must break ties the same way: the first entry of the ring wins.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "edgewise/table/contract.hpp"

namespace edgewise {

/// The edge of the ring with the most negative distance, the first of equals; nothing if none is negative.
template <class Table, class Ring, class DistanceOf>
[[nodiscard]] std::optional<typename Table::Edge> most_violated(const Ring& ring, DistanceOf distance_of) {
    std::optional<typename Table::Edge> worst;
    ComputeOf<Table> least = 0;
    for (const auto [edge, flipped] : ring) {
        const ComputeOf<Table> d = distance_of(edge, flipped);
        if (d < least) {
            least = d;
            worst = edge;
        }
    }
    return worst;
}

/// The edge whose vertex-edge plane the point violates most (the steepest way out of the vertex's region), or
/// nothing when the point is inside the region.
template <FeatureTable Table>
[[nodiscard]] std::optional<typename Table::Edge> most_violated_vertex_plane(
    const Table& table, typename Table::Vertex v, const Vec3<ComputeOf<Table>>& point) {
    if constexpr (requires { table.most_violated_vertex_plane(v, point); }) {
        return table.most_violated_vertex_plane(v, point);
    } else {
        return most_violated<Table>(table.ring_of_vertex(v), [&](auto edge, bool flipped) {
            return table.vertex_edge_plane(edge, flipped ? End::head : End::tail).distance(point);
        });
    }
}

/// The edge whose edge-face plane the point violates most, or nothing when the point is in the face's prism.
/// The maximum matters here: at an obtuse corner the first violated plane may belong to the wrong edge.
template <FeatureTable Table>
[[nodiscard]] std::optional<typename Table::Edge> most_violated_face_side(
    const Table& table, typename Table::Face f, const Vec3<ComputeOf<Table>>& point) {
    if constexpr (requires { table.most_violated_face_side(f, point); }) {
        return table.most_violated_face_side(f, point);
    } else {
        return most_violated<Table>(table.ring_of_face(f), [&](auto edge, bool flipped) {
            return table.edge_face_plane(edge, flipped ? Side::right : Side::left).distance(point);
        });
    }
}

/// The incident edge that falls steepest along `normal` and how steep every edge is at most.
template <FeatureTable Table>
struct Descent {
    std::optional<typename Table::Edge> edge;
    ComputeOf<Table> slope = 0;     ///< of that edge, leaving the vertex; negative
    ComputeOf<Table> steepest = 0;  ///< largest |slope| in the ring
};

template <FeatureTable Table>
[[nodiscard]] Descent<Table> steepest_descent(const Table& table, typename Table::Vertex v,
                                              const Vec3<ComputeOf<Table>>& normal) {
    if constexpr (requires { table.steepest_descent(v, normal); }) {
        return table.steepest_descent(v, normal);
    } else {
        Descent<Table> result;
        for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
            const auto along = dot(table.direction(edge), normal);
            const auto slope = flipped ? -along : along;
            result.steepest = std::max(result.steepest, std::abs(slope));
            if (slope < result.slope) {
                result.slope = slope;
                result.edge = edge;
            }
        }
        return result;
    }
}

}  // namespace edgewise
