// SPDX-License-Identifier: MIT
//
// Questions about a whole ring, with a generic answer. A layout that can answer in one vectorised pass
// defines a member of the same name; it must break ties the same way: the first entry of the ring wins.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "edgewise/table/contract.hpp"

namespace edgewise {

/// Edge with this name in the ring of a vertex; the name is its handle, or a place in the ring.
template <FeatureTable Table>
[[nodiscard]] typename Table::Edge edge_in_ring(const Table& table, typename Table::Vertex v,
                                                const auto& name) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(name)>, typename Table::Edge>)
        return name;
    else
        return table.edge_in_ring(v, name);
}

/// Calls visit(name, vertex-edge plane) around a vertex, in the order of its ring, until it returns false.
template <FeatureTable Table, class Visit>
void visit_vertex_planes(const Table& table, typename Table::Vertex v, Visit visit) {
    if constexpr (requires { table.visit_vertex_planes(v, visit); }) {
        table.visit_vertex_planes(v, visit);
    } else {
        for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
            if (!visit(edge, table.vertex_edge_plane(edge, flipped ? End::head : End::tail))) return;
        }
    }
}

/// Calls visit(edge, edge-face plane) around a face, in the order of its ring, until it returns false.
template <FeatureTable Table, class Visit>
void visit_face_sides(const Table& table, typename Table::Face f, Visit visit) {
    if constexpr (requires { table.visit_face_sides(f, visit); }) {
        table.visit_face_sides(f, visit);
    } else {
        for (const auto [edge, flipped] : table.ring_of_face(f)) {
            if (!visit(edge, table.edge_face_plane(edge, flipped ? Side::right : Side::left))) return;
        }
    }
}

/// Type of the names of edges in rings of vertices.
template <FeatureTable Table>
struct RingNameOf {
    using Type = typename Table::Edge;
};
template <FeatureTable Table>
requires requires { typename Table::RingName; }
struct RingNameOf<Table> {
    using Type = typename Table::RingName;
};

/// Name of the plane that the point violates most, the first of equals; nothing if it violates none.
/// `visit_all(visit)` calls visit(name, plane) for each.
template <class Name, class Scalar, class VisitAll>
[[nodiscard]] std::optional<Name> most_violated(const Vec3<Scalar>& point, VisitAll visit_all) {
    Name worst{};
    Scalar least = 0;
    visit_all([&](const Name& name, const auto& plane) {
        const Scalar d = plane.distance(point);
        if (d < least) worst = name;
        least = d < least ? d : least;
        return true;
    });
    return least < 0 ? std::optional(worst) : std::nullopt;
}

/// Returns the edge with the vertex-edge plane that the point violates most (the steepest way out of the
/// vertex's region), or nothing when the point is inside the region.
template <FeatureTable Table>
[[nodiscard]] std::optional<typename Table::Edge> most_violated_vertex_plane(
    const Table& table, typename Table::Vertex v, const Vec3<ComputeOf<Table>>& point) {
    if constexpr (requires { table.most_violated_vertex_plane(v, point); }) {
        return table.most_violated_vertex_plane(v, point);
    } else {
        const auto name = most_violated<typename RingNameOf<Table>::Type>(
            point, [&](auto visit) { visit_vertex_planes(table, v, visit); });
        return name ? std::optional(edge_in_ring(table, v, *name)) : std::nullopt;
    }
}

/// Returns the edge with the edge-face plane that the point violates most; nothing inside the face's prism.
/// The maximum matters here: at an obtuse corner the first violated plane may be of the wrong edge.
template <FeatureTable Table>
[[nodiscard]] std::optional<typename Table::Edge> most_violated_face_side(
    const Table& table, typename Table::Face f, const Vec3<ComputeOf<Table>>& point) {
    if constexpr (requires { table.most_violated_face_side(f, point); }) {
        return table.most_violated_face_side(f, point);
    } else {
        return most_violated<typename Table::Edge>(point,
                                                   [&](auto visit) { visit_face_sides(table, f, visit); });
    }
}

/// The face's plane for signs and ratios of heights: the length of its normal is arbitrary.
template <FeatureTable Table>
[[nodiscard]] auto unscaled_face_plane(const Table& table, typename Table::Face f) {
    if constexpr (requires { table.unscaled_face_plane(f); })
        return table.unscaled_face_plane(f);
    else
        return table.face_plane(f);
}

/// Square of a slope, with the slope's sign: edges derived from their ends have it without a square root.
template <class Scalar>
[[nodiscard]] Scalar squared_slope(Scalar slope) {
    return slope * std::abs(slope);
}

/// Squared slope of the edge, tail to head, along a normal, times the square of the normal's length.
template <FeatureTable Table>
[[nodiscard]] ComputeOf<Table> slope_along(const Table& table, typename Table::Edge e,
                                           const Vec3<ComputeOf<Table>>& normal) {
    if constexpr (requires { table.slope_along(e, normal); }) {
        return table.slope_along(e, normal);
    } else {
        return squared_slope(dot(table.direction(e), normal));
    }
}

/// The incident edge with the steepest descent along `normal`, and the largest slope; both squared.
template <class Edge, class Scalar>
struct Descent {
    std::optional<Edge> edge;
    Scalar slope = 0;     ///< slope of that edge, leaving the vertex; negative
    Scalar steepest = 0;  ///< largest |slope| in the ring, if an edge descends; else not set
};

template <FeatureTable Table>
[[nodiscard]] Descent<typename Table::Edge, ComputeOf<Table>> steepest_descent(
    const Table& table, typename Table::Vertex v, const Vec3<ComputeOf<Table>>& normal) {
    if constexpr (requires { table.steepest_descent(v, normal); }) {
        return table.steepest_descent(v, normal);
    } else {
        Descent<typename Table::Edge, ComputeOf<Table>> result;
        for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
            const auto along = slope_along(table, edge, normal);
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
