// SPDX-License-Identifier: MIT
//
// Weights by Cramer's rule with a common denominator, so that everything stays in integers.
#include "edgewise/truth/optimality.hpp"

#include <stdexcept>

namespace edgewise::truth {

namespace {

/// total * (nearest point) is what the weights give, where nearest point = (h / u.u) u.
bool is_weighted_mean(const MinimumSimplex<IntegerVec>& s) {
    const std::array<mpz_class, 4> weights = simplex_weights(s);
    mpz_class total;
    IntegerVec sum;
    for (int i = 0; i < s.size; ++i) {
        if (sgn(weights[i]) < 0) return false;
        total += weights[i];
        sum += weights[i] * s.point[i];
    }
    if (sgn(total) <= 0) return false;
    if (s.holds_origin()) return sum.is_zero();
    const mpz_class along = total * s.height;
    return dot(s.direction, s.direction) * sum == along * s.direction;
}

}  // namespace

/// Written out per size, not shared with the search.
std::array<mpz_class, 4> simplex_weights(const MinimumSimplex<IntegerVec>& s) {
    const std::array<IntegerVec, 4>& p = s.point;
    if (s.size == 1) return {mpz_class(1), 0, 0, 0};
    if (s.size == 2) {
        const IntegerVec edge = p[1] - p[0];
        return {dot(p[1], edge), -dot(p[0], edge), 0, 0};
    }
    if (s.size == 3) {
        const IntegerVec normal = cross(p[1] - p[0], p[2] - p[0]);
        return {dot(normal, cross(p[1], p[2])), dot(normal, cross(p[2], p[0])),
                dot(normal, cross(p[0], p[1])), 0};
    }
    std::array<mpz_class, 4> w = {dot(p[1], cross(p[2], p[3])), -dot(p[0], cross(p[2], p[3])),
                                  dot(p[0], cross(p[1], p[3])), -dot(p[0], cross(p[1], p[2]))};
    if (sgn(w[0]) < 0) {
        for (mpz_class& weight : w) weight = -weight;
    }
    return w;
}

void require_optimal(ExactPair& bodies, const MinimumSimplex<IntegerVec>& simplex) {
    for (int i = 0; i < simplex.size; ++i) {
        if (!(simplex.point[i] == bodies.difference(simplex.pair[i]))) {
            throw std::logic_error("exact distance: a simplex point is not the difference of its vertices");
        }
    }
    if (!is_weighted_mean(simplex)) {
        throw std::logic_error("exact distance: the nearest point is not in the hull of its simplex");
    }
    if (simplex.holds_origin()) return;
    if (bodies.lowest(simplex.direction).height < simplex.height) {
        throw std::logic_error("exact distance: a vertex pair lies below the nearest point");
    }
}

}  // namespace edgewise::truth
