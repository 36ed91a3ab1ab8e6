// SPDX-License-Identifier: MIT
//
// The point of a simplex closest to the origin, by Johnson's cofactors (johnson.hpp) without his search: all
// of them are computed, in one line of arithmetic, and their signs, as bits of one word, say which subset
// passes. Trying one subset after the other takes a branch for each, which no processor can predict: it was
// 44 % of GJK's instructions and 65 % of its mispredicted branches.
//
// Departures. The cofactors of a whole tetrahedron are products of six lengths, which overflow and vanish
// early in single precision; their signs are those of its corner volumes, products of three. The chosen
// subset is tried as Johnson tries it, against every other point. If that fails, or nothing passes, Johnson's
// search decides: its backup, and its care for flat tetrahedra, are needed then.
#pragma once

#include <bit>
#include <cassert>
#include <cstdint>

#include "edgewise/algorithms/johnson.hpp"
#include "edgewise/algorithms/subset.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// D_k(X + {k}) for a subset X of `count` points with known cofactors; `Number` may have lanes.
template <class Number, int count, class Points, class Known>
[[nodiscard]] [[gnu::always_inline]] inline Number cofactor(const Points& w, const Known& of, int subset,
                                                            int k) {
    if (subset == 0) return Number{} + 1;
    const int m = std::countr_zero(static_cast<unsigned>(subset));
    Number sum = Number{};
#pragma GCC unroll 4
    for (int i = m; i < count; ++i) {
        if (!(subset >> i & 1)) continue;
        // In one order only, so that the compiler finds products that are needed twice.
        const Number slope = m < k ? Number(dot(w[i], w[m] - w[k])) : Number(-dot(w[i], w[k] - w[m]));
        const Number term =
            std::has_single_bit(static_cast<unsigned>(subset)) ? slope : Number(of[subset][i] * slope);
        sum = i == m ? term : Number(sum + term);
    }
    return sum;
}

/// Six times the volume of a tetrahedron, and of the tetrahedra of the origin with each face: the cofactors
/// of the whole are the corners' times the whole's. `Number` may have lanes.
template <class Number>
struct CornersOfWhole {
    SmallArray<Number, 4> corner;
    Number whole;

    template <class Vector>
    [[gnu::always_inline]] explicit CornersOfWhole(const SmallArray<Vector, 4>& w) {
        const Vector p = w[1] - w[0], q = w[2] - w[0], r = w[3] - w[0];
        const Vector across = cross(p, q);
        whole = dot(r, across);
        // Differences before products.
        corner = {dot(w[1], cross(Vector(q - p), Vector(r - p))), -dot(w[0], cross(q, r)),
                  dot(w[0], cross(p, r)), -dot(w[0], across)};
    }
};

/// The cofactors of every subset of `count` points that the closest point may rest on. If it is known to rest
/// on the newest point, the last one, that is half of the subsets. Loops are unrolled, so that only
/// arithmetic is left.
template <class Scalar, int count, bool newest_belongs>
class Cofactors {
  public:
    using Points = SimplexPoints<Scalar>;

    [[gnu::always_inline]] explicit Cofactors(const Points& w) {
#pragma GCC unroll 16
        for (int subset = 1; subset < proper_end; ++subset) {
            if (!is_asked(subset) && !is_asked_with_newest(subset)) continue;
#pragma GCC unroll 4
            for (int k = 0; k < count; ++k) {
                const bool member = subset >> k & 1;
                of_[subset][k] = member ? cofactor<Scalar, count>(w, of_, subset & ~(1 << k), k) : Scalar(0);
                if (member && is_asked(subset)) positive_ |= bit_of(subset, k, of_[subset][k] > 0);
            }
        }
        if constexpr (count == 4) add_volumes(w);
    }

    /// Bit i is set if by its signs the closest point rests on ascending_subsets[i].
    [[nodiscard]] [[gnu::always_inline]] unsigned passing() const {
        unsigned result = 0;
#pragma GCC unroll 16
        for (unsigned i = 0; i < ascending_subsets.size(); ++i) {
            const int subset = ascending_subsets[i];
            if (subset >= subsets || !is_asked(subset)) continue;
            std::uint64_t asked = 0, wanted = 0;
#pragma GCC unroll 4
            for (int k = 0; k < count; ++k) {
                asked |= bit_of(subset | 1 << k, k);
                if (subset >> k & 1) wanted |= bit_of(subset, k);
            }
            result |= static_cast<unsigned>((positive_ & asked) == wanted) << i;
        }
        return result;
    }

    /// Cofactors of the points of a subset other than the whole; 0 for points outside the subset.
    [[nodiscard]] const SmallArray<Scalar, 4>& of(PointMask subset) const { return of_[subset]; }

  private:
    static constexpr int subsets = 1 << count;
    static constexpr int proper_end = count == 4 ? 15 : subsets;  ///< without the whole of four
    static constexpr int newest = 1 << (count - 1);

    /// Returns true if the closest point may rest on this subset.
    [[nodiscard]] static constexpr bool is_asked(int subset) {
        return !newest_belongs || (subset & newest) != 0;
    }
    /// Returns true if this subset's cofactors are needed for those of the subset with the newest point.
    [[nodiscard]] static constexpr bool is_asked_with_newest(int subset) {
        return (subset | newest) < proper_end;
    }

    [[nodiscard]] static constexpr std::uint64_t bit_of(int subset, int k, bool set = true) {
        return static_cast<std::uint64_t>(set) << (4 * subset + k);
    }

    /// Adds the signs of the whole's cofactors.
    [[gnu::always_inline]] void add_volumes(const Points& w) {
        const CornersOfWhole<Scalar> volumes(w);
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) {
            const Scalar corner = volumes.corner[k];
            positive_ |= bit_of(15, k, corner > 0 ? volumes.whole > 0 : (corner < 0) & (volumes.whole < 0));
        }
    }

    SmallArray<SmallArray<Scalar, 4>, proper_end> of_;
    std::uint64_t positive_ = 0;
};

/// Computes the weights of the subset that passes by its signs; false if none does, or rounding misleads.
template <int count, bool newest_belongs, class Scalar>
[[nodiscard]] [[gnu::always_inline]] inline bool weigh_passing(const SimplexPoints<Scalar>& w,
                                                               ClosestOfSimplex<Scalar>& found) {
    const Cofactors<Scalar, count, newest_belongs> cofactors(w);
    const unsigned passing = cofactors.passing();
    if (passing == 0) return false;
    const PointMask subset = ascending_subsets[std::countr_zero(passing)];
    const auto& weights = cofactors.of(subset);
    Scalar sum = 0;
#pragma GCC unroll 4
    for (int i = 0; i < count; ++i) sum += weights[i];
    Vec3<Scalar> point = Vec3<Scalar>::Zero();
#pragma GCC unroll 4
    for (int i = 0; i < count; ++i) {
        found.weight[i] = weights[i] / sum;
        point += found.weight[i] * w[i];
    }
    found.rest_on(subset, w, point);
    const Vec3<Scalar>& member = w[lowest_point(subset)];
    bool excludes = true;
#pragma GCC unroll 4
    for (int k = 0; k < count; ++k) {
        excludes &= (subset >> k & 1) | !(dot(found.point, member - w[k]) > 0);
    }
    return excludes;
}

/// Calls weigh_passing for any count above one.
template <bool newest_belongs, class Scalar>
[[nodiscard]] [[gnu::always_inline]] inline bool weigh_passing_of(const SimplexPoints<Scalar>& w, int count,
                                                                  ClosestOfSimplex<Scalar>& found) {
    if (count == 3) return weigh_passing<3, newest_belongs>(w, found);
    if (count == 4) return weigh_passing<4, newest_belongs>(w, found);
    return weigh_passing<2, newest_belongs>(w, found);
}

/// Finds the closest point by search, where no subset passes by its signs.
template <class Scalar>
[[gnu::noinline]] void search_closest(const SimplexPoints<Scalar>& w, int count,
                                      ClosestOfSimplex<Scalar>& found) {
    Johnson<Scalar> johnson(w, count);
    found = johnson.holds_origin() ? johnson.inside() : johnson.closest();
}

/// Finds the closest point of any simplex, and of a simplex that is known to rest on its newest point: two
/// functions, since their branches go different ways.
template <class Scalar>
[[gnu::noinline]] EDGEWISE_IN_QUERY_LOOP void find_closest_of_any(const SimplexPoints<Scalar>& w, int count,
                                                                  ClosestOfSimplex<Scalar>& found) {
    if (!weigh_passing_of<false>(w, count, found)) search_closest(w, count, found);
}
template <class Scalar>
[[gnu::noinline]] EDGEWISE_IN_QUERY_LOOP void find_closest_with_newest(const SimplexPoints<Scalar>& w,
                                                                       int count,
                                                                       ClosestOfSimplex<Scalar>& found) {
    if (!weigh_passing_of<true>(w, count, found)) search_closest(w, count, found);
}

/// The point of w[0 .. count-1], 1 <= count <= 4, closest to the origin. `newest_belongs`: it is known to
/// rest on the last of them, in exact arithmetic.
template <class Scalar>
void find_closest(const SimplexPoints<Scalar>& w, int count, bool newest_belongs,
                  ClosestOfSimplex<Scalar>& found) {
    assert(count >= 1 && count <= 4);
    if (count == 1) {
        found.weight[0] = 1;
        found.rest_on(1, w, w[0]);
    } else if (newest_belongs) {
        find_closest_with_newest(w, count, found);
    } else {
        find_closest_of_any(w, count, found);
    }
}

}  // namespace edgewise
