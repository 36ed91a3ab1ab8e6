// SPDX-License-Identifier: MIT
//
// The vertices of the bodies in all lanes, coordinates side by side, and their support points by scans: small
// bodies are scanned anyway (support.hpp), and side by side a scan has no branch.
#pragma once

#include <cassert>

#include "edgewise/algorithms/lanes/lane_source.hpp"
#include "edgewise/algorithms/lanes/lane_vector.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// One body per lane. A lane with fewer vertices than another repeats its first vertex: a repeated vertex
/// never comes first of equals.
template <class Scalar, int n>
class LaneBodies {
  public:
    using Vector = LaneVec<Scalar, n>;

    struct Farthest {
        Masks<Scalar, n> vertex;
        Vector point;
    };

    /// Returns true if this lane holds the body of this table.
    [[nodiscard]] bool holds(int lane, const void* table) const { return tables_[lane] == table; }
    /// Place for this lane's body of `vertices` vertices; call pad() after writing them.
    [[nodiscard]] LaneVertices<Scalar> room(int lane, const void* table, int vertices) {
        assert(vertices >= 1 && vertices <= static_cast<int>(most_lane_vertices));
        for (; used_ < vertices; ++used_) vertices_[used_] = vertices_[0];
        tables_[lane] = table;
        written_[lane] = vertices;
        return {reinterpret_cast<Scalar*>(vertices_.data()) + lane, n};
    }
    void pad(int lane) {
        const Vector& first = vertices_[0];
        for (int i = written_[lane]; i < used_; ++i)
            vertices_[i].set(lane, first.x[lane], first.y[lane], first.z[lane]);
    }

    /// The first of the vertices farthest along each lane's direction.
    [[nodiscard]] [[gnu::always_inline]] Farthest farthest(const Vector& direction) const {
        Numbers<Scalar, n> most = dot(vertices_[0], direction);
        Masks<Scalar, n> vertex{}, next{};
        for (int i = 1; i < used_; ++i) {
            const Numbers<Scalar, n> along = dot(vertices_[i], direction);
            const Masks<Scalar, n> higher = along > most;
            next = next + 1;
            most = select(higher, along, most);
            vertex = select(higher, next, vertex);
        }
        return {vertex, at(vertex)};
    }

  private:
    /// Each lane's vertex of this number, read once at the end: to carry it along costs a third of a scan.
    [[nodiscard]] [[gnu::always_inline]] Vector at(const Masks<Scalar, n>& vertex) const {
        Vector point;
#pragma GCC unroll 8
        for (int lane = 0; lane < n; ++lane) {
            const Vector& from = vertices_[static_cast<int>(vertex[lane])];
            point.set(lane, from.x[lane], from.y[lane], from.z[lane]);
        }
        return point;
    }

    SmallArray<Vector, most_lane_vertices> vertices_{};
    SmallArray<const void*, n> tables_{};
    SmallArray<int, n> written_{};
    int used_ = 1;  ///< most vertices that any lane had
};

}  // namespace edgewise
