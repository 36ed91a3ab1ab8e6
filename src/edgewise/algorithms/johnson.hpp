// SPDX-License-Identifier: MIT
//
// Johnson's sub-distance algorithm: the point of a simplex (at most four points) closest to the origin.
//
// Gilbert, Johnson, Keerthi 1988; the paper's equations 7 and 8. Sub-simplices are tried in ascending size,
// so that most queries end early, and cofactors are shared between them: the cofactor of point k in X + {k}
// is
//     D_k(X + {k}) = sum over i in X of D_i(X) * <w_i, w_m - w_k>,   m any point of X.
// A subset X holds the closest point v when every D_i(X) > 0 and no other point k lies on the origin's side,
// <v, w_m - w_k> <= 0, which has the sign of D_k(X + {k}). Differences are taken before products:
// cancellation in <w_i,w_m> - <w_i,w_k> is where the textbook form loses its digits.
//
// Departures. A tetrahedron holds the origin only if the signed volumes of its four corners say so beyond
// their rounding: on a flat one the cofactors are noise and may all be positive. And when rounding leaves no
// subset that passes, the backup procedure weighs every subset whose cofactors are positive by its own
// distance and takes the nearest; positive weights always give a point of the simplex, so that answer is
// never a lie.
//
// Johnson, not signed volumes throughout, is the default because it is what the reproduced paper ran, and
// because the backup already covers flat simplices. Where the processor computes, its loops over subsets and
// points are unrolled: with the subset known when compiled nothing is left of them but arithmetic, the same
// to the bit. (As loops they were 44 % of GJK's instructions and 65 % of its mispredicted branches.)
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/geometry/vec.hpp"

namespace edgewise {

/// A subset of a simplex's points; bit i: point i belongs to it.
using PointMask = std::uint8_t;

/// Three points. (std::popcount is a call into a library where the machine may lack the instruction.)
[[nodiscard]] constexpr bool is_triangle(PointMask mask) {
    constexpr unsigned triangles = 1U << 7 | 1U << 11 | 1U << 13 | 1U << 14;
    return (triangles >> mask & 1U) != 0;
}

[[nodiscard]] constexpr int lowest_point(PointMask mask) {
    assert(mask != 0);
    return std::countr_zero(mask);
}

/// A triangle by two of its sides, from one corner.
template <class Scalar>
struct TriangleSides {
    Vec3<Scalar> p, q;

    [[nodiscard]] bool is_thin() const {
        const Scalar longest = squared_side();
        return !(squared_norm(cross(p, q)) > Tolerance<Scalar>::thin * longest * longest);
    }

    /// The closest point to the origin, from the weighted sum of the corners: that, or its foot on the normal
    /// through the origin. Where the triangle is long and low (length over height k) the weights are off by
    /// k^2 rounding steps, the sum by k^2 times the length, and its direction, along which the next support
    /// point is sought, by that over its own length; the normal's direction is off by k steps. The better
    /// known one wins; of a sliver, whose normal is noise, the sum, which at least is a point of the
    /// triangle.
    [[nodiscard]] Vec3<Scalar> foot(const Vec3<Scalar>& weighted) const {
        const Vec3<Scalar> normal = cross(p, q);
        const Scalar squared = squared_norm(normal), longest = squared_side();
        // Squared, as `longest` is: no product of more than four lengths.
        const Scalar height = squared / longest;
        const bool sliver = !(height > Tolerance<Scalar>::sliver * longest);
        if (sliver || height * squared_norm(weighted) >= longest * longest) return weighted;
        return (dot(normal, weighted) / squared) * normal;
    }

  private:
    /// Of the longer one.
    [[nodiscard]] Scalar squared_side() const { return std::max(squared_norm(p), squared_norm(q)); }
};

/// The triple product with every sign turned positive: what its rounding is relative to.
template <class Scalar>
[[nodiscard]] Scalar unsigned_volume(const Vec3<Scalar>& a, const Vec3<Scalar>& b, const Vec3<Scalar>& c) {
    const auto size = [](const Scalar& s) {
        using std::abs;
        return abs(s);
    };
    return size(a.x()) * (size(b.y() * c.z()) + size(b.z() * c.y())) +
           size(a.y()) * (size(b.z() * c.x()) + size(b.x() * c.z())) +
           size(a.z()) * (size(b.x() * c.y()) + size(b.y() * c.x()));
}

/// Signed volumes of the origin with each face of a tetrahedron: the cofactors of its four points.
template <class Scalar>
struct CornerVolumes {
    std::array<Scalar, 4> volume;
    bool hold_origin;  ///< all of one sign, beyond their rounding

    explicit CornerVolumes(const std::array<Vec3<Scalar>, 4>& w) {
        bool positive = true, negative = true;
        for (int k = 0; k < 4; ++k) {
            const auto &a = w[(k + 1) & 3], &b = w[(k + 2) & 3], &c = w[(k + 3) & 3];
            volume[k] = dot(a, cross(b, c)) * (k & 1 ? -1 : 1);
            const Scalar noise = Tolerance<Scalar>::volume_noise * unsigned_volume(a, b, c);
            positive = positive && volume[k] > noise;
            negative = negative && volume[k] < -noise;
        }
        hold_origin = positive || negative;
    }
};

/// What Johnson's algorithm finds.
template <class Scalar>
struct ClosestOfSimplex {
    PointMask members = 0;
    std::array<Scalar, 4> weight{};  ///< of members; they sum to one
    Vec3<Scalar> point;
    bool backup = false;  ///< the ascending pass found nothing
};

template <class Scalar>
class Johnson {
  public:
    using Mask = PointMask;
    using Closest = ClosestOfSimplex<Scalar>;

    static constexpr Mask none = 0, whole = 15;
    [[nodiscard]] static constexpr Mask only(int point) { return static_cast<Mask>(1 << point); }
    /// Points are w[0 .. count-1], 1 <= count <= 4.
    Johnson(const std::array<Vec3<Scalar>, 4>& w, int count) : w_(w), count_(count) {
        assert(count >= 1 && count <= 4);
    }

    /// Whether a tetrahedron holds the origin, before any subset is tried.
    [[nodiscard]] bool holds_origin() { return count_ == 4 && volumes_hold_origin(); }
    [[nodiscard]] Closest inside() const { return weigh(whole, 4); }

    /// `known`: points that the answer is known to rest on, such as the newest of a search, in exact
    /// arithmetic. Subsets without them are tried only when no other passes.
    [[nodiscard]] Closest closest(Mask known = none) {
        if (Closest found; ascend(known, found)) return found;
        if (count_ == 4 && volumes_hold_origin()) return weigh(whole, 4);
        return known == none ? nearest_of_all() : closest();
    }

    /// Too long and low for its foot to be as good as its points are.
    [[nodiscard]] bool is_thin(Mask mask) const { return is_triangle(mask) && triangle(mask).is_thin(); }

  private:
    static constexpr std::array<Mask, 14> ascending = {1, 2, 4, 8, 3, 5, 6, 9, 10, 12, 7, 11, 13, 14};

    /// The first subset that passes, in ascending size; false if none does.
    [[nodiscard]] bool ascend(Mask known, Closest& found) {
        if constexpr (std::is_floating_point_v<Scalar>) {
            if (count_ == 2) return ascend_unrolled<2>(known, found);
            if (count_ == 3) return ascend_unrolled<3>(known, found);
            if (count_ == 4) return ascend_unrolled<4>(known, found);
        }
        return std::any_of(ascending.begin(), ascending.end(), [&](Mask mask) {
            return mask >> count_ == 0 && passes(mask, count_, known, found);
        });
    }
    template <int count>
    [[nodiscard]] bool ascend_unrolled(Mask known, Closest& found) {
        return [&]<std::size_t... at>(std::index_sequence<at...>) {
            return ((ascending[at] >> count == 0 && passes(ascending[at], count, known, found)) || ...);
        }
        (std::make_index_sequence<ascending.size()>());
    }

    /// This and what it calls are given the mask and the number of points as constants, if it is unrolled.
    [[gnu::always_inline]] bool passes(Mask mask, int count, Mask known, Closest& found) {
        if (!cofactors(mask, count) || (mask & known) != known) return false;
        found = weigh(mask, count);
        return excludes_others(mask, count, found.point);
    }

    bool volumes_hold_origin() {
        const CornerVolumes<Scalar> corners(w_);
        cofactor_[whole] = corners.volume;
        return corners.hold_origin;
    }

    /// <w_i, w_m - w_k>
    [[nodiscard]] Scalar slope(int i, int m, int k) const { return dot(w_[i], w_[m] - w_[k]); }

    /// D_k(X + {k}) for a subset whose own cofactors are known.
    [[nodiscard]] [[gnu::always_inline]] Scalar cofactor_of(Mask subset, int count, int k) const {
        const int m = lowest_point(subset);
        Scalar sum = 0;
        for (int i = m; i < count; ++i) {
            if (subset >> i & 1) sum += cofactor_[subset][i] * slope(i, m, k);
        }
        return sum;
    }

    /// Cofactors of every member, from the subsets one smaller; true when all are positive.
    [[gnu::always_inline]] bool cofactors(Mask mask, int count) {
        if ((mask & (mask - 1)) == 0) {
            cofactor_[mask][lowest_point(mask)] = 1;
            return true;
        }
        bool positive = true;
        for (int k = 0; k < count; ++k) {
            if (!(mask >> k & 1)) continue;
            const Scalar value = cofactor_of(static_cast<Mask>(mask & ~(1 << k)), count, k);
            cofactor_[mask][k] = value;
            positive = positive && value > 0;
        }
        return positive;
    }

    /// No other point lies nearer along the direction of this subset's closest point.
    [[nodiscard]] [[gnu::always_inline]] bool excludes_others(Mask mask, int count,
                                                              const Vec3<Scalar>& point) const {
        const int m = lowest_point(mask);
        for (int k = 0; k < count; ++k) {
            if (!(mask >> k & 1) && dot(point, w_[m] - w_[k]) > 0) return false;
        }
        return true;
    }

    [[nodiscard]] [[gnu::always_inline]] Closest weigh(Mask mask, int count) const {
        Closest result;
        assert(mask >> count == 0 && "members are points that are there");
        result.members = mask;
        Scalar sum = 0;
        for (int i = 0; i < count; ++i) {
            if (mask >> i & 1) sum += cofactor_[mask][i];
        }
        result.point = Vec3<Scalar>::Zero();
        for (int i = 0; i < count; ++i) {
            if (!(mask >> i & 1)) continue;
            result.weight[i] = cofactor_[mask][i] / sum;
            result.point += result.weight[i] * w_[i];
        }
        if (is_triangle(mask)) result.point = triangle(mask).foot(result.point);
        return result;
    }

    [[nodiscard]] TriangleSides<Scalar> triangle(Mask mask) const {
        const int i = lowest_point(mask);
        assert(is_triangle(mask));
        const int j = lowest_point(static_cast<Mask>(mask & (mask - 1)));
        const int k = std::bit_width(mask) - 1;
        return {w_[j] - w_[i], w_[k] - w_[i]};
    }

    /// The backup procedure. All cofactors are known by now.
    [[nodiscard]] [[gnu::noinline]] Closest nearest_of_all() {
        Closest best;
        Scalar least = -1;
        for (const Mask mask : ascending) {
            if (mask >> count_) continue;
            if (!cofactors(mask, count_)) continue;
            const Closest candidate = weigh(mask, count_);
            const Scalar squared = squared_norm(candidate.point);
            if (least < 0 || squared < least) {
                least = squared;
                best = candidate;
            }
        }
        best.backup = true;
        return best;
    }

    const std::array<Vec3<Scalar>, 4>& w_;
    int count_;
    std::array<std::array<Scalar, 4>, 16> cofactor_;
};

}  // namespace edgewise
