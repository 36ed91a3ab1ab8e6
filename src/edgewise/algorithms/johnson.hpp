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
// Departures. A tetrahedron holds the origin only if the signed volumes of its four corners show it beyond
// their rounding: on a flat one the cofactors are noise and may all be positive. If rounding leaves no
// subset that passes, the backup procedure computes the distance of every subset with positive cofactors
// and takes the nearest; positive weights always give a point of the simplex, so the answer is never
// invalid. It also checks triangles with almost collinear corners, because their cofactors are noise.
//
// Johnson, not signed volumes throughout, because the replicated paper ran it, and because the backup already
// covers flat simplices. Unless it is asked for (query_options.hpp), most simplices are decided without
// its loops, by the same cofactors (cofactors.hpp).
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>

#include "edgewise/algorithms/subset.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// The triple product with every sign turned positive: its rounding is relative to this.
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
    SmallArray<Scalar, 4> volume;
    bool hold_origin;  ///< all of one sign, beyond their rounding

    explicit CornerVolumes(const SimplexPoints<Scalar>& w) {
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

template <class Scalar>
class Johnson {
  public:
    using Mask = PointMask;
    using Closest = ClosestOfSimplex<Scalar>;

    static constexpr Mask whole = 15;

    /// Takes the points w[0 .. count-1], 1 <= count <= 4.
    Johnson(const SimplexPoints<Scalar>& w, int count) : w_(w), count_(count) {
        assert(count >= 1 && count <= 4);
    }

    /// Returns true if a tetrahedron holds the origin, before any subset is tried.
    [[nodiscard]] bool holds_origin() { return count_ == 4 && volumes_hold_origin(); }
    [[nodiscard]] Closest inside() const { return weigh(whole); }

    /// Out of line: unless chosen, called only where the cofactors' signs decide nothing (cofactors.hpp).
    [[nodiscard]] [[gnu::noinline]] Closest closest() {
        if (Closest found; ascend(found)) return found.thin ? nearer_of(found) : found;
        if (count_ == 4 && volumes_hold_origin()) return weigh(whole);
        return nearest_of_all();
    }

  private:
    /// Finds the first subset that passes, in ascending size; false if none does.
    [[nodiscard]] bool ascend(Closest& found) {
        return std::any_of(ascending_subsets.begin(), ascending_subsets.end(), [&](Mask mask) {
            if (mask >> count_ != 0 || !cofactors(mask)) return false;
            found = weigh(mask);
            return excludes_others(mask, found.point);
        });
    }

    bool volumes_hold_origin() {
        const CornerVolumes<Scalar> corners(w_);
        cofactor_[whole] = corners.volume;
        return corners.hold_origin;
    }

    /// <w_i, w_m - w_k>
    [[nodiscard]] Scalar slope(int i, int m, int k) const { return dot(w_[i], w_[m] - w_[k]); }

    /// D_k(X + {k}) for a subset with known cofactors.
    [[nodiscard]] Scalar cofactor_of(Mask subset, int k) const {
        const int m = lowest_point(subset);
        Scalar sum = 0;
        for (int i = m; i < count_; ++i) {
            if (subset >> i & 1) sum += cofactor_[subset][i] * slope(i, m, k);
        }
        return sum;
    }

    /// Computes cofactors of every member, from the subsets one smaller; true when all are positive.
    bool cofactors(Mask mask) {
        if ((mask & (mask - 1)) == 0) {
            cofactor_[mask][lowest_point(mask)] = 1;
            return true;
        }
        bool positive = true;
        for (int k = 0; k < count_; ++k) {
            if (!(mask >> k & 1)) continue;
            const Scalar value = cofactor_of(static_cast<Mask>(mask & ~(1 << k)), k);
            cofactor_[mask][k] = value;
            positive = positive && value > 0;
        }
        return positive;
    }

    /// Returns true if no other point lies nearer along the direction of this subset's closest point.
    [[nodiscard]] bool excludes_others(Mask mask, const Vec3<Scalar>& point) const {
        const int m = lowest_point(mask);
        for (int k = 0; k < count_; ++k) {
            if (!(mask >> k & 1) && dot(point, w_[m] - w_[k]) > 0) return false;
        }
        return true;
    }

    [[nodiscard]] Closest weigh(Mask mask) const {
        Closest result;
        assert(mask >> count_ == 0 && "members are points that are there");
        Scalar sum = 0;
        for (int i = 0; i < count_; ++i) {
            if (mask >> i & 1) sum += cofactor_[mask][i];
        }
        Vec3<Scalar> weighted = Vec3<Scalar>::Zero();
        for (int i = 0; i < count_; ++i) {
            if (!(mask >> i & 1)) continue;
            result.weight[i] = cofactor_[mask][i] / sum;
            weighted += result.weight[i] * w_[i];
        }
        result.rest_on(mask, w_, weighted);
        return result;
    }

    /// Cofactors of a triangle with collinear corners are noise, and all three may be positive: the point
    /// that they weigh is then farther than that of a side.
    [[nodiscard]] [[gnu::noinline]] Closest nearer_of(const Closest& triangle) {
        const Closest nearest = nearest_of_all();
        return squared_norm(nearest.point) < squared_norm(triangle.point) ? nearest : triangle;
    }

    /// The backup procedure. All cofactors are known by then.
    [[nodiscard]] Closest nearest_of_all() {
        Closest best;
        Scalar least = -1;
        for (const Mask mask : ascending_subsets) {
            if (mask >> count_) continue;
            if (!cofactors(mask)) continue;
            const Closest candidate = weigh(mask);
            const Scalar squared = squared_norm(candidate.point);
            if (least < 0 || squared < least) {
                least = squared;
                best = candidate;
            }
        }
        best.backup = true;
        return best;
    }

    const SimplexPoints<Scalar>& w_;
    int count_;
    SmallArray<SmallArray<Scalar, 4>, 16> cofactor_;
};

}  // namespace edgewise
