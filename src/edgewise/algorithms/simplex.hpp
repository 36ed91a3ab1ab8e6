// SPDX-License-Identifier: MIT
//
// GJK's simplex while a query runs.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>

#include "edgewise/algorithms/subset.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// Up to four pairs of vertices, and the points they stand for in the Minkowski difference (A's frame).
template <SupportTable TableA, SupportTable TableB>
struct Simplex {
    using Scalar = ComputeOf<TableA>;

    int count = 0;
    std::array<typename TableA::Vertex, 4> vertex_a;
    std::array<typename TableB::Vertex, 4> vertex_b;
    std::array<Vec3<Scalar>, 4> on_a, on_b;  ///< both in A's frame
    std::array<Vec3<Scalar>, 4> difference;
    Scalar size = 0;  ///< longest coordinate of all points pushed so far: what rounding is relative to

    void push(typename TableA::Vertex a, typename TableB::Vertex b, const Vec3<Scalar>& point_a,
              const Vec3<Scalar>& point_b) {
        assert(count < 4);
        vertex_a[count] = a;
        vertex_b[count] = b;
        on_a[count] = point_a;
        on_b[count] = point_b;
        difference[count] = point_a - point_b;
        ++count;
        size = std::max({size, max_abs(point_a), max_abs(point_b)});
    }

    /// As if the last push had not been; `before`: the size then.
    void drop_newest(Scalar before) {
        assert(count > 0);
        --count;
        size = before;
    }

    [[nodiscard]] bool holds(typename TableA::Vertex a, typename TableB::Vertex b) const {
        for (int i = 0; i < count; ++i) {
            if (vertex_a[i] == a && vertex_b[i] == b) return true;
        }
        return false;
    }

    /// Drops what the closest point does not rest on; weights move along. Which points those are no processor
    /// can predict: all are copied down, and what is dropped is written over by the next.
    void keep(ClosestOfSimplex<Scalar>& closest) {
        int kept = 0;
        for (int i = 0; i < count; ++i) {
            vertex_a[kept] = vertex_a[i];
            vertex_b[kept] = vertex_b[i];
            on_a[kept] = on_a[i];
            on_b[kept] = on_b[i];
            difference[kept] = difference[i];
            closest.weight[kept] = closest.weight[i];
            kept += closest.members >> i & 1;
        }
        assert(kept > 0 && "a closest point rests on some vertex");
        count = kept;
    }
};

/// Of the squared distance: a last simplex whose closest point promises no more than this is far off. A
/// matter of time, not of right answers.
inline constexpr double far_off_simplex = 0.5;

}  // namespace edgewise
