// SPDX-License-Identifier: MIT
//
// GJK's sub-distance for several queries side by side: cofactors.hpp without its branches. All cofactors of
// all lanes' simplices are computed. Where a lane's signs choose no subset, or the chosen one needs more
// care (another point lies nearer, a thin triangle), the lane is not `sure`, and its query is asked by
// itself.
#pragma once

#include <bit>
#include <cstddef>

#include "edgewise/algorithms/cofactors.hpp"
#include "edgewise/algorithms/lanes/lane_vector.hpp"
#include "edgewise/algorithms/subset.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// The closest points to the origin of n simplices. Each is known to rest on its newest point, w[3], whatever
/// comes before it.
template <class Scalar, int n>
class LaneClosest {
  public:
    using Number = Numbers<Scalar, n>;
    using Mask = Masks<Scalar, n>;
    using Word = typename LaneTypes<Scalar, n>::Word;
    using Vector = LaneVec<Scalar, n>;
    using Points = SmallArray<Vector, 4>;

    /// `older`: number of points per lane besides the newest: the first of w, 0 to 3.
    [[gnu::always_inline]] LaneClosest(const Points& w, const Mask& older) {
#pragma GCC unroll 3
        for (int k = 0; k < 3; ++k) absent_[k] = older <= k;
        add_cofactors(w);
        if (any_lane(older == 3)) add_volumes(w);
        choose();
        weigh(w);
        if (any_lane(is_triangle())) find_foot(w);
        try_others(w);
    }

    [[nodiscard]] const Vector& point() const { return point_; }
    [[nodiscard]] const Number& weight(int k) const { return weight_[k]; }
    /// Mask of the lanes where the closest point rests on point k.
    [[nodiscard]] [[gnu::always_inline]] Mask rests_on(int k) const {
        return (subset_ & (Mask{} + (Word{1} << k))) != 0;
    }
    [[nodiscard]] const Mask& sure() const { return sure_; }

  private:
    static constexpr int newest = 8, whole = 15;

    [[gnu::always_inline]] void add_cofactors(const Points& w) {
#pragma GCC unroll 16
        for (int subset = 1; subset < whole; ++subset) {
            if ((subset | newest) == whole && !(subset & newest)) continue;  // no needed subset uses it
#pragma GCC unroll 4
            for (int k = 0; k < 4; ++k) {
                if (!(subset >> k & 1)) continue;
                if (subset == 1 << k)
                    of_[subset][k] = Number{} + 1;
                else
                    of_[subset][k] = cofactor<Number, 4>(w, of_, subset & ~(1 << k), k);
                if (subset & newest) positive_[subset][k] = of_[subset][k] > 0;
            }
        }
        for (int k = 0; k < 4; ++k) positive_[whole][k] = Mask{};
    }

    [[gnu::always_inline]] void add_volumes(const Points& w) {
        const CornersOfWhole<Number> volumes(w);
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) {
            const Number& corner = volumes.corner[k];
            positive_[whole][k] = ((corner > 0) & (volumes.whole > 0)) | ((corner < 0) & (volumes.whole < 0));
        }
    }

    /// Chooses the first subset that holds the newest point and passes by its signs, in Johnson's order.
    [[gnu::always_inline]] void choose() {
        subset_ = Mask{};
#pragma GCC unroll 4
        for (Number& weight : weight_) weight = Number{};
#pragma GCC unroll 16
        for (const int subset : ascending_subsets) {
            if (!(subset & newest)) continue;
            Mask first = subset_ == 0;
#pragma GCC unroll 4
            for (int k = 0; k < 4; ++k) {
                const Mask& positive = positive_[subset | 1 << k][k];
                if (k == 3)
                    first &= positive;
                else
                    first &= subset >> k & 1 ? positive & ~absent_[k] : ~positive | absent_[k];
            }
            subset_ |= first & subset;
#pragma GCC unroll 4
            for (int k = 0; k < 4; ++k) {
                if (subset >> k & 1) weight_[k] = (Number)((Mask)weight_[k] | (first & (Mask)of_[subset][k]));
            }
        }
        sure_ = subset_ != 0;
    }

    [[gnu::always_inline]] void weigh(const Points& w) {
        Number sum = Number{};
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) sum += weight_[k];
        point_ = Vector{};
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) {
            weight_[k] = weight_[k] / sum;
            point_ = point_ + weight_[k] * w[k];
        }
    }

    /// Mask of the lanes that rest on the newest point and two others.
    [[nodiscard]] [[gnu::always_inline]] Mask is_triangle() const {
        return (subset_ == 11) | (subset_ == 13) | (subset_ == 14);
    }

    /// Takes the foot on the triangle's normal, as TriangleSides does, where it is more accurate.
    [[gnu::always_inline]] void find_foot(const Points& w) {
        const Vector lowest = select(subset_ == 14, w[1], w[0]);
        const Vector second = select(subset_ >= 13, w[2], w[1]);
        const Vector p = second - lowest, q = w[3] - lowest;
        const Vector normal = cross(p, q);
        const Number squared = squared_norm(normal);
        const Number longest = larger(squared_norm(p), squared_norm(q));
        const Mask thin = ~(squared > Tolerance<Scalar>::thin * longest * longest);
        const Number height = squared / longest;
        const Mask sliver = ~(height > Tolerance<Scalar>::sliver * longest);
        const Mask stays = sliver | (height * squared_norm(point_) >= longest * longest);
        const Vector foot = (dot(normal, point_) / squared) * normal;
        const Mask triangle = is_triangle();
        point_ = select(triangle & ~stays, foot, point_);
        sure_ &= ~(triangle & thin);
    }

    /// Checks that no other point lies nearer along the direction of the chosen subset's closest point.
    [[gnu::always_inline]] void try_others(const Points& w) {
        Vector member = w[3];
#pragma GCC unroll 4
        for (int k = 2; k >= 0; --k) member = select(rests_on(k), w[k], member);
#pragma GCC unroll 4
        for (int k = 0; k < 3; ++k) {
            const Mask nearer = dot(point_, member - w[k]) > 0;
            sure_ &= rests_on(k) | absent_[k] | ~nearer;
        }
    }

    SmallArray<Mask, 3> absent_;  ///< mask of lanes without this older point
    SmallArray<SmallArray<Number, 4>, 15> of_;
    SmallArray<SmallArray<Mask, 4>, 16> positive_;
    SmallArray<Number, 4> weight_;
    Mask subset_, sure_;
    Vector point_;
};

}  // namespace edgewise
