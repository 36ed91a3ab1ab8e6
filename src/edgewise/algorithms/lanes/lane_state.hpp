// SPDX-License-Identifier: MIT
//
// GJK's state of the query in each lane: bodies, pose, simplex. Small bodies are scanned anyway
// (support.hpp), and with coordinates of all lanes side by side a scan has no branch.
#pragma once

#include <cassert>
#include <cstdint>

#include "edgewise/algorithms/lanes/lane_source.hpp"
#include "edgewise/algorithms/lanes/lane_vector.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// The vertices of the bodies in all lanes, one body per lane. A lane with fewer vertices than another
/// repeats its first vertex: a repeated vertex never comes first of equals.
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

template <class Scalar, int n>
struct LaneState {
    using Number = Numbers<Scalar, n>;
    using Mask = Masks<Scalar, n>;
    using Vector = LaneVec<Scalar, n>;
    using Word = typename LaneTypes<Scalar, n>::Word;

    LaneBodies<Scalar, n> a, b;
    SmallArray<Number, 9> rotation{};  ///< of a_from_b, row by row
    Vector translation{}, closest{};
    /// Holds the first `count`, up to three; the newest, while it is added, is the last.
    SmallArray<Mask, 4> vertices{};  ///< A's and B's as one word
    SmallArray<Vector, 4> difference{};
    SmallArray<Number, 4> weight{};
    Number size{};
    Mask count{}, steps{};
    Mask starts{};     ///< without a point so far
    Mask is_active{};  ///< holds a query

    /// Loads the source's next query; without one the lane is idle.
    void load(int lane, LaneSource<Scalar>& source) {
        LaneQuery<Scalar> query;
        is_active[lane] = 0;
        if (!source.next(lane, query)) return;
        is_active[lane] = -1;
        if (!a.holds(lane, query.table_a)) {
            source.write_a(lane, a.room(lane, query.table_a, query.vertices_a));
            a.pad(lane);
        }
        if (!b.holds(lane, query.table_b)) {
            source.write_b(lane, b.room(lane, query.table_b, query.vertices_b));
            b.pad(lane);
        }
        for (int i = 0; i < 9; ++i) rotation[i][lane] = query.a_from_b.rotation(i / 3, i % 3);
        set(translation, lane, query.a_from_b.translation);
        starts[lane] = -1;
        count[lane] = 0;
        size[lane] = 0;
        steps[lane] = 0;
    }

    [[nodiscard]] LaneAnswer<Scalar> answer(int lane) const {
        LaneAnswer<Scalar> result;
        result.count = static_cast<int>(count[lane]);
        for (int k = 0; k < result.count; ++k) {
            result.vertex_a[k] = static_cast<std::uint32_t>(vertices[k][lane] >> 16);
            result.vertex_b[k] = static_cast<std::uint32_t>(vertices[k][lane] & 0xffff);
            result.weight[k] = weight[k][lane];
        }
        result.closest = {closest.x[lane], closest.y[lane], closest.z[lane]};
        result.steps = static_cast<int>(steps[lane]);
        return result;
    }

    [[nodiscard]] [[gnu::always_inline]] Vector direction_back(const Vector& v) const {
        const auto& r = rotation;
        return {r[0] * v.x + r[3] * v.y + r[6] * v.z, r[1] * v.x + r[4] * v.y + r[7] * v.z,
                r[2] * v.x + r[5] * v.y + r[8] * v.z};
    }
    [[nodiscard]] [[gnu::always_inline]] Vector point_of_b(const Vector& p) const {
        const auto& r = rotation;
        const Vector turned = {r[0] * p.x + r[1] * p.y + r[2] * p.z, r[3] * p.x + r[4] * p.y + r[5] * p.z,
                               r[6] * p.x + r[7] * p.y + r[8] * p.z};
        return turned + translation;
    }

    [[nodiscard]] [[gnu::always_inline]] Mask holds(const Mask& both) const {
        Mask held{};
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k) held |= (count > k) & (vertices[k] == both);
        return held;
    }

    /// Adds a point in every lane: the newest, in the last of four places.
    [[gnu::always_inline]] void push(const Mask& both, const Vector& of_difference) {
        vertices[3] = both;
        difference[3] = of_difference;
    }

    /// Drops the points that the closest one (LaneClosest) does not rest on, as Simplex::keep does. A lane
    /// that rests on all four is asked by itself, and its last point may be lost here. `size_now`: size with
    /// the newest points; `fresh`: mask of lanes that hold no point yet.
    template <class Closest>
    [[gnu::always_inline]] void keep(const Closest& now, const Number& size_now, const Mask& fresh) {
        Mask kept{};
#pragma GCC unroll 4
        for (int from = 0; from < 4; ++from) {
#pragma GCC unroll 3
            for (int to = 0; to <= from && to < 3; ++to) {
                const Mask here = kept == to;
                vertices[to] = select(here, vertices[from], vertices[to]);
                difference[to] = select(here, difference[from], difference[to]);
                weight[to] = select(here, now.weight(from), weight[to]);
            }
            kept -= now.rests_on(from);
        }
        count = kept & ~fresh;
        size = select(fresh, Number{}, size_now);
        starts = fresh;
    }

  private:
    static void set(Vector& vector, int lane, const Vec3<Scalar>& to) {
        vector.set(lane, to.x(), to.y(), to.z());
    }
};

}  // namespace edgewise
