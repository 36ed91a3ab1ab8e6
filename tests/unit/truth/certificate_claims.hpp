// SPDX-License-Identifier: MIT
//
// Shared parts of the tests of certificates: pairs, claims about them, and the exact result, which is not a
// double but the rational square that exact_distance rounds.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "edgewise/truth/certificate.hpp"
#include "edgewise/truth/dyadic.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "edgewise/truth/exact_proof.hpp"
#include "exact_bodies.hpp"

namespace edgewise::truth::certificate_claims {

using Pair = PosedPoints;

/// Closest points and direction that an answer claims.
struct Claim {
    std::vector<std::uint32_t> on_a, on_b;
    std::vector<double> weights;
    Vec3d direction = Vec3d::Zero();

    [[nodiscard]] Certificate certify(const Pair& pair, bool weighted = true) const {
        const std::span<const double> w =
            weighted ? std::span<const double>(weights) : std::span<const double>();
        const auto result = edgewise::truth::certify(pair.a, pair.pose_a, pair.b, pair.pose_b, {on_a, w},
                                                     {on_b, w}, direction);
        EXPECT_TRUE(result) << result.error;
        return result ? *result : Certificate{-1, -1};
    }
};

struct Truth {
    mpq_class square;
    Claim claim;  ///< the true one, as well as doubles can say it
    ExactVerdict verdict = ExactVerdict::separated;
};

[[nodiscard]] inline mpq_class power_of_two(long exponent) {
    mpz_class power = 1;
    power <<= static_cast<mp_bitcnt_t>(std::abs(exponent));
    return exponent < 0 ? mpq_class(1, power) : mpq_class(power);
}

[[nodiscard]] inline Truth truth_of(const Pair& pair) {
    const auto exact = exact_distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
    ExactPair bodies(pair.a, pair.pose_a, pair.b, pair.pose_b);
    MinimumSimplex<IntegerVec> simplex;
    simplex.size = exact->simplex.size;
    Truth truth;
    truth.verdict = exact->verdict;
    for (int i = 0; i < simplex.size; ++i) {
        simplex.point[i] = bodies.difference(exact->simplex.pair[i]);
        truth.claim.on_a.push_back(exact->simplex.pair[i].a);
        truth.claim.on_b.push_back(exact->simplex.pair[i].b);
    }
    SubsetTrial<IntegerVec> nearest = subset_of<IntegerVec>(simplex, ~0U, nullptr);
    EXPECT_TRUE(find_direction(nearest));
    const std::array<mpz_class, 4> weights = simplex_weights(simplex);
    const mpz_class total = weights[0] + weights[1] + weights[2] + weights[3];
    for (int i = 0; i < simplex.size; ++i) {
        truth.claim.weights.push_back(rounded_quotient(weights[i], total, 0));
    }
    if (sgn(nearest.height) == 0) return truth;
    truth.square = mpq_class(nearest.height * nearest.height, dot(nearest.direction, nearest.direction));
    truth.square.canonicalize();
    truth.square *= power_of_two(2 * bodies.unit);
    truth.claim.direction = rounded_direction(nearest.direction);
    return truth;
}

[[nodiscard]] inline ::testing::AssertionResult holds(const Certificate& c, const mpq_class& square) {
    const bool below = c.lower >= 0 && mpq_class(c.lower) * mpq_class(c.lower) <= square;
    const bool above = std::isinf(c.upper) || mpq_class(c.upper) * mpq_class(c.upper) >= square;
    if (below && above) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << c.lower << " to " << c.upper << " misses " << std::sqrt(square.get_d());
}

[[nodiscard]] inline double log_uniform(RandomBodies& random, int low, int high) {
    const double mantissa = 1 + std::abs(random.number());
    return std::ldexp(mantissa,
                      low + static_cast<int>(random.bits()() % static_cast<unsigned>(high - low + 1)));
}

[[nodiscard]] inline Pair round_pair(RandomBodies& random, double apart) {
    const auto points = [&] { return random.on_sphere(4 + static_cast<int>(random.bits()() % 36)); };
    Pair pair{points(), points(), {random.rotation(), random.unit()}, {}};
    pair.pose_b = {random.rotation(), pair.pose_a.translation + apart * random.unit()};
    return pair;
}

/// Moved along the separation until a gap, or a small overlap, is left.
[[nodiscard]] inline Pair grazing(RandomBodies& random) {
    Pair pair = round_pair(random, 2.5);
    const auto exact = exact_distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
    const double left = random.number() * log_uniform(random, -52, -1);
    pair.pose_b.translation += (1 - left) * exact->separation;
    return pair;
}

}  // namespace edgewise::truth::certificate_claims
