// SPDX-License-Identifier: MIT
//
// GJK's simplex while a query runs. Its points stay in their own places as long as they belong to it; only
// their differences are kept in order, because the next iteration reads only these.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>

#include "edgewise/algorithms/subset.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// Up to four pairs of vertices, and their points in the Minkowski difference (A's frame).
template <SupportTable TableA, SupportTable TableB>
class Simplex {
  public:
    using Scalar = ComputeOf<TableA>;

    int count = 0;
    SimplexPoints<Scalar> difference;
    Scalar size = 0;  ///< longest coordinate of all points pushed so far: rounding is relative to it

    [[nodiscard]] typename TableA::Vertex vertex_a(int i) const { return vertex_a_[place_[i]]; }
    [[nodiscard]] typename TableB::Vertex vertex_b(int i) const { return vertex_b_[place_[i]]; }
    /// Points of A and B, both in A's frame.
    [[nodiscard]] const Vec3<Scalar>& on_a(int i) const { return on_a_[place_[i]]; }
    [[nodiscard]] const Vec3<Scalar>& on_b(int i) const { return on_b_[place_[i]]; }

    void clear() {
        count = 0;
        size = 0;
        taken_ = 0;
    }

    void push(typename TableA::Vertex a, typename TableB::Vertex b, const Vec3<Scalar>& point_a,
              const Vec3<Scalar>& point_b) {
        assert(count < 4);
        const auto place = static_cast<std::uint8_t>(std::countr_one(taken_));
        taken_ |= 1U << place;
        place_[count] = place;
        vertex_a_[place] = a;
        vertex_b_[place] = b;
        on_a_[place] = point_a;
        on_b_[place] = point_b;
        difference[count] = point_a - point_b;
        ++count;
        size = std::max({size, max_abs(point_a), max_abs(point_b)});
    }

    /// Undoes the last push; `before`: the size before it.
    void drop_newest(Scalar before) {
        assert(count > 0);
        --count;
        taken_ &= ~(1U << place_[count]);
        size = before;
    }

    /// Compares all pairs, because no processor can predict which of them matches.
    [[nodiscard]] bool holds(typename TableA::Vertex a, typename TableB::Vertex b) const {
        unsigned equal = 0;
#pragma GCC unroll 4
        for (unsigned i = 0; i < 4; ++i)
            equal |= (static_cast<unsigned>(vertex_a_[i] == a) & static_cast<unsigned>(vertex_b_[i] == b))
                     << i;
        return (equal & taken_) != 0;
    }

    /// Drops the points that the closest point does not rest on; weights move along. No processor can predict
    /// which points stay: all are copied down, and the next push overwrites the dropped ones.
    void keep(ClosestOfSimplex<Scalar>& closest) {
        int kept = 0;
        unsigned taken = 0;
#pragma GCC unroll 4
        for (int i = 0; i < 4; ++i) {
            const unsigned stays = unsigned{closest.members} >> i & 1U;
            const std::uint8_t place = place_[i];
            taken |= stays << place;
            place_[kept] = place;
            difference[kept] = difference[i];
            closest.weight[kept] = closest.weight[i];
            kept += static_cast<int>(stays);
        }
        assert(kept > 0 && kept <= count && "a closest point rests on some vertex");
        count = kept;
        taken_ = taken;
    }

  private:
    SmallArray<std::uint8_t, 4> place_{};  ///< of each point in the following
    std::array<typename TableA::Vertex, 4> vertex_a_{};
    std::array<typename TableB::Vertex, 4> vertex_b_{};
    std::array<Vec3<Scalar>, 4> on_a_, on_b_;
    unsigned taken_ = 0;  ///< bit i: place i holds a point
};

}  // namespace edgewise
