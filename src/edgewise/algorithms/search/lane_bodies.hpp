// SPDX-License-Identifier: MIT
//
// The vertices of small bodies, in single precision, and which of them is farthest: of one body a row of
// vertices at a time, and of the eight bodies of eight searches.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "edgewise/algorithms/search/lane_vector.hpp"
#include "edgewise/algorithms/search/sides.hpp"
#include "edgewise/algorithms/search/single_search.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// Takes and scans the vertices of one body, a row of `size` at a time; `lane`: 0 to size - 1.
template <int size, class Lanes = std::make_integer_sequence<int, size>>
struct Rows;
template <int size, int... lane>
struct Rows<size, std::integer_sequence<int, lane...>> {
    using Row = Numbers<size>;
    using Places = Masks<size>;

    [[nodiscard, gnu::always_inline]] static const Row& row(const float* first) {
        return *reinterpret_cast<const Row*>(first);
    }
    [[nodiscard, gnu::always_inline]] static Row& row(float* first) { return *reinterpret_cast<Row*>(first); }

    /// Takes B's vertices to A's frame.
    [[gnu::always_inline]] static void move_to_a(const SingleSearch& of, SingleVertices& to) {
        const auto& m = of.rotation;
        const auto& t = of.translation;
        to.count = of.b.count;
        for (std::size_t i = 0; i < of.b.count; i += size) {
            const Row x = row(&of.b.x[i]), y = row(&of.b.y[i]), z = row(&of.b.z[i]);
            row(&to.x[i]) = m(0, 0) * x + m(0, 1) * y + m(0, 2) * z + t.x();
            row(&to.y[i]) = m(1, 0) * x + m(1, 1) * y + m(1, 2) * z + t.y();
            row(&to.z[i]) = m(2, 0) * x + m(2, 1) * y + m(2, 2) * z + t.z();
        }
    }

    /// The first of the vertices farthest along d, or, if not `along`, against it.
    template <bool along>
    [[nodiscard, gnu::always_inline]] static std::int32_t farthest(const SingleVertices& of, const Four& d) {
        // Counted down from the most, so that 0 is left for none.
        Places where = Places{} + int{SingleVertices::most} - Places{lane...}, places = where;
        Row most = row(&of.x[0]) * d[0] + row(&of.y[0]) * d[1] + row(&of.z[0]) * d[2];
        for (std::size_t i = size; i < of.count; i += size) {
            const Row next = row(&of.x[i]) * d[0] + row(&of.y[i]) * d[1] + row(&of.z[i]) * d[2];
            places = places - size;
            where = (along ? next > most : next < most) ? places : where;
            join<along>(most, next);
        }
        Row top = most;
        everywhere<along>(top);
        where &= most == top;
        everywhere<true>(where);
        return -where[0] & int{SingleVertices::most - 1};
    }

  private:
    /// The greater, or the smaller, of two.
    template <bool greater, class Vector>
    [[gnu::always_inline]] static void join(Vector& of, const Vector& other) {
        of = (greater ? other > of : other < of) ? other : of;
    }
    /// The greatest, or the smallest, lane in all lanes.
    template <bool greatest, class Vector>
    [[gnu::always_inline]] static void everywhere(Vector& of) {
        if constexpr (size == 8) join<greatest>(of, __builtin_shufflevector(of, of, (lane ^ 4)...));
        join<greatest>(of, __builtin_shufflevector(of, of, (lane ^ 2)...));
        join<greatest>(of, __builtin_shufflevector(of, of, (lane ^ 1)...));
    }
};

/// One body per lane. Small ones are scanned side by side, where a lane with fewer vertices than another
/// repeats its first vertex: a repeated vertex never comes first of equals. Large ones are scanned one after
/// the other, by rows.
class LaneBodies {
  public:
    struct Farthest {
        EightWords vertex;
        LaneVec point;
    };

    /// A large body is read where it is: it must live until the lane's next one.
    [[gnu::always_inline]] void write(int lane, const SingleVertices& from) {
        const int count = static_cast<int>(from.count);
        const bool is_large = count > few;
        by_rows_ = (by_rows_ & ~(1U << lane)) | unsigned{is_large} << lane;
        large_[lane] = &from;
        if (is_large) return;
        for (; used_ < count; ++used_) vertices_[used_] = vertices_[0];
        for (int first = 0; first < count; first += lane_count) {
            const auto k = static_cast<std::size_t>(first);
            const LaneVec row = {Row::row(&from.x[k]), Row::row(&from.y[k]), Row::row(&from.z[k])};
#pragma GCC unroll 8
            for (int i = 0; i < lane_count; ++i) vertices_[first + i].set(lane, row.x[i], row.y[i], row.z[i]);
        }
        for (int i = count; i < used_; ++i) vertices_[i].set(lane, from.x[0], from.y[0], from.z[0]);
    }

    /// The first of the vertices farthest along each lane's direction, or, if not `along`, against it.
    template <bool along>
    [[nodiscard, gnu::always_inline]] Farthest farthest(const LaneVec& direction) const {
        Farthest found{};
        if (by_rows_ != all_lanes) found = side_by_side(along ? direction : -direction);
        for (unsigned left = by_rows_; left != 0; left &= left - 1) {
            const int lane = std::countr_zero(left);
            const SingleVertices& body = *large_[lane];
            const Four d = {direction.x[lane], direction.y[lane], direction.z[lane], 0};
            found.vertex[lane] = Row::farthest<along>(body, d);
            const auto k = static_cast<std::size_t>(found.vertex[lane]);
            found.point.set(lane, body.x[k], body.y[k], body.z[k]);
        }
        return found;
    }

  private:
    using Row = Rows<lane_count>;
    static constexpr unsigned all_lanes = (1U << lane_count) - 1;
    /// Most vertices of a small body. Cold batches by rows over side by side, Zen 4: 1.07 of the time at 8
    /// vertices, 0.86 at 38.
    static constexpr int few = 16;

    [[nodiscard, gnu::always_inline]] Farthest side_by_side(const LaneVec& direction) const {
        Eight most = dot(vertices_[0], direction);
        EightWords vertex{}, place{};
        for (int i = 1; i < used_; ++i) {
            const Eight along = dot(vertices_[i], direction);
            const EightWords higher = along > most;
            place = place + 1;
            most = higher ? along : most;
            vertex = higher ? place : vertex;
        }
        return {vertex, at(vertex)};
    }

    /// Each lane's vertex of this number, read once at the end: to carry it along costs a third of a scan.
    [[nodiscard, gnu::always_inline]] LaneVec at(const EightWords& vertex) const {
        LaneVec point;
#pragma GCC unroll 8
        for (int lane = 0; lane < lane_count; ++lane) {
            const LaneVec& from = vertices_[static_cast<int>(vertex[lane])];
            point.set(lane, from.x[lane], from.y[lane], from.z[lane]);
        }
        return point;
    }

    SmallArray<LaneVec, few> vertices_{};
    int used_ = 1;          ///< most vertices that any lane had side by side
    unsigned by_rows_ = 0;  ///< the lanes with a large body, a bit each
    SmallArray<const SingleVertices*, lane_count> large_{};
};

}  // namespace edgewise
