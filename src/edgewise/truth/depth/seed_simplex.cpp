// SPDX-License-Identifier: MIT
//
// GJK over the filter's coordinates, shifted by the exact offset between the bodies rounded once, so the
// guess is good however far from the origin the pair is. Stops when nothing improves; needs no tolerance,
// because no result depends on the guess.
#include <algorithm>
#include <cmath>

#include "edgewise/truth/exact_body.hpp"

namespace edgewise::truth {

namespace {

constexpr int iteration_limit = 64;  // a cap on wasted time only: exact iterations take over from there

/// A - B in doubles, in units that keep the largest of the two shapes and the offset near 1.
class RoundedDifference {
  public:
    explicit RoundedDifference(ExactPair& bodies) : a_(bodies.a.filter()), b_(bodies.b.filter()) {
        std::array<long, 3> exponents{};
        offset_ = mantissas(bodies.difference({0, 0}), exponents);
        long unit = std::max(a_.exponent(), b_.exponent());
        for (int i = 0; i < 3; ++i) {
            exponents[i] += bodies.unit;
            if (offset_[i] != 0) unit = std::max(unit, exponents[i]);
        }
        for (int i = 0; i < 3; ++i) offset_[i] = shifted(offset_[i], exponents[i] - unit);
        scale_a_ = shifted(1, a_.exponent() - unit);
        scale_b_ = shifted(1, b_.exponent() - unit);
    }

    [[nodiscard]] Vec3d point(VertexPair pair) const {
        return scale_a_ * a_.shape(pair.a) - scale_b_ * b_.shape(pair.b) + offset_;
    }

    [[nodiscard]] VertexPair lowest(const Vec3d& direction) const {
        return {a_.lowest(direction), b_.lowest(-direction)};
    }

  private:
    static double shifted(double x, long exponent) {
        return std::ldexp(x, static_cast<int>(std::max(exponent, -4000L)));
    }

    SupportFilter& a_;
    SupportFilter& b_;
    Vec3d offset_;
    double scale_a_ = 1;
    double scale_b_ = 1;
};

double squared_distance(const MinimumSimplex<Vec3d>& simplex) {
    return simplex.height * simplex.height / squared_norm(simplex.direction);
}

void descend(const RoundedDifference& difference, MinimumSimplex<Vec3d>& simplex) {
    for (int i = 0; i < iteration_limit && simplex.size < 4 && simplex.height > 0; ++i) {
        const VertexPair pair = difference.lowest(simplex.direction);
        const Vec3d point = difference.point(pair);
        const auto end = simplex.pair.begin() + simplex.size;
        if (std::find(simplex.pair.begin(), end, pair) != end) return;
        if (!(dot(simplex.direction, point) < simplex.height)) return;
        MinimumSimplex<Vec3d> next = simplex;
        if (!add_point(next, point, pair)) return;
        if (next.size < 4 && !(squared_distance(next) < squared_distance(simplex))) return;
        simplex = next;
    }
}

}  // namespace

SimplexSeed seed_simplex(ExactPair& bodies, const SimplexSeed& start) {
    if (!bodies.a.filter().usable() || !bodies.b.filter().usable()) return {{}, 1};
    const RoundedDifference difference(bodies);
    MinimumSimplex<Vec3d> simplex;
    for (int i = 0; i < start.size; ++i) {
        const VertexPair pair = start.pair[i];
        if (pair.a >= bodies.a.size() || pair.b >= bodies.b.size()) continue;
        const Vec3d point = difference.point(pair);
        if (simplex.size > 0 && !(dot(simplex.direction, point) < simplex.height)) continue;
        if (simplex.size < 4) static_cast<void>(add_point(simplex, point, pair));
    }
    if (simplex.size == 0) static_cast<void>(add_point(simplex, difference.point({0, 0}), VertexPair{0, 0}));
    descend(difference, simplex);
    return {simplex.pair, simplex.size};
}

}  // namespace edgewise::truth
