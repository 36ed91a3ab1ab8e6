// SPDX-License-Identifier: MIT
//
// The support point: the vertex farthest along a direction. Large bodies climb along neighbour rings
// (Cameron, "Enhancing GJK", ICRA 1997): on a convex body a vertex none of whose neighbours is farther is the
// farthest. Small bodies are scanned: below the break-even a scan's predictable loop beats the climb's
// unpredictable one. Bodies that are not strictly convex are scanned too: where neighbours lie on one plane
// or almost in one place, rounding makes plateaus on which a climb ends far below the top.
#pragma once

#include <cassert>
#include <cstddef>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// Vertices below which a linear scan is used. Measured over scalar tables on a Zen 5 (time of climbing over
/// time of scanning, GJK on `cold`, separated / contact): 0.89 / 1.06 at 8 vertices, 0.79 / 1.04 at 18, 0.67
/// / 0.97 at 38. Others switch at 10 to 32; a vectorised scan would move the point up.
inline constexpr std::size_t scan_below = 8;

template <class Table>
struct SupportPoint {
    typename Table::Vertex vertex;
    Vec3<ComputeOf<Table>> point;
    ComputeOf<Table> along;  ///< <point, direction>
};

/// The farthest vertex of all, the first of equals. A layout that can scan faster defines a member of the
/// same name, with the same answer to the bit.
template <SupportTable Table>
[[nodiscard]] [[gnu::noinline]] SupportPoint<Table> scan_support(const Table& table,
                                                                 const Vec3<ComputeOf<Table>>& direction) {
    if constexpr (requires { table.scan_support(direction); }) {
        const auto [vertex, point, along] = table.scan_support(direction);
        return {vertex, point, along};
    } else {
        const auto first = table.first_vertex();
        const auto start = table.vertex(first);
        SupportPoint<Table> best{first, start, dot(start, direction)};
        for (const auto v : table.all_vertices()) {
            const auto point = table.vertex(v);
            const auto along = dot(point, direction);
            if (along > best.along) best = {v, point, along};
        }
        return best;
    }
}

/// Whether an edge between these is short beside where it lies.
template <class Scalar>
[[nodiscard]] bool is_short(const Vec3<Scalar>& tail, const Vec3<Scalar>& head) {
    return max_abs(Vec3<Scalar>(head - tail)) < Tolerance<Scalar>::short_edge * max_abs(head);
}

/// Steepest ascent from `start`. Strictly upward, so it ends within as many rounds as there are vertices;
/// else the shape changes while it is asked, and a scan decides. A neighbour as high as the top but for
/// rounding may hide a slope behind it, the steeper the shorter the edge to it: behind a short one a scan
/// looks.
template <ClimbingTable Table>
[[nodiscard]] SupportPoint<Table> climb_support(const Table& table, const Vec3<ComputeOf<Table>>& direction,
                                                typename Table::Vertex start) {
    using Scalar = ComputeOf<Table>;
    const auto point = table.vertex(start);
    SupportPoint<Table> best{start, point, dot(point, direction)};
    const Scalar noise = Tolerance<Scalar>::support_noise * max_abs(point) * max_abs(direction);
    for (std::size_t round = 0; round <= table.vertex_count(); ++round) {
        bool improved = false, hidden = false;
        for (const auto v : table.neighbours(best.vertex)) {
            const auto candidate = table.vertex(v);
            const auto along = dot(candidate, direction);
            if (along > best.along) {
                best.point = candidate;
                best.along = along;
                start = v;
                improved = true;
            } else if (along >= best.along - noise) {
                hidden |= is_short(best.point, candidate);
            }
        }
        best.vertex = start;
        if (improved) continue;
        return hidden ? scan_support(table, direction) : best;
    }
    assert(false && "a climb passed more vertices than there are");
    return scan_support(table, direction);
}

/// Climbed to from `start` where that pays and is safe, else found by a scan.
template <SupportTable Table>
[[nodiscard]] SupportPoint<Table> support(const Table& table, const Vec3<ComputeOf<Table>>& direction,
                                          [[maybe_unused]] typename Table::Vertex start) {
    if constexpr (ClimbingTable<Table>) {
        if (table.strictly_convex() && table.vertex_count() >= scan_below)
            return climb_support(table, direction, start);
    }
    return scan_support(table, direction);
}

}  // namespace edgewise
