// SPDX-License-Identifier: MIT
//
// The exact oracle on random pairs: against brute force in double, against itself under swap, permutation and
// scaling by powers of two, from any seed; and its parts against the arithmetic of the processor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "brute_force.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/truth/dyadic.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

struct RandomPair : PosedPoints {
    /// Sizes 4 to `largest`, thin or round, centres up to 2.5 apart.
    RandomPair(RandomBodies& random, int largest) {
        const auto count = [&] { return 4 + static_cast<int>(random.bits()() % (largest - 3)); };
        a = random.on_sphere(count());
        b = random.on_sphere(count());
        const double thin = std::ldexp(1.0, -static_cast<int>(random.bits()() % 12));
        for (Vec3d& v : b) v.z() *= thin;
        pose_a = {random.rotation(), random.unit()};
        pose_b = {random.rotation(), pose_a.translation + 1.25 * (1 + random.number()) * random.unit()};
    }

    [[nodiscard]] ExactDistance ask(const SimplexSeed& seed = {}) const {
        return *exact_distance(a, pose_a, b, pose_b, seed);
    }
};

void expect_same(const ExactDistance& x, const ExactDistance& y, double factor = 1) {
    EXPECT_EQ(x.verdict, y.verdict);
    EXPECT_EQ(x.distance * std::abs(factor), y.distance);
    EXPECT_EQ(Vec3d(x.separation * factor), y.separation);
}

TEST(ExactDistanceRandom, agrees_with_brute_force) {
    RandomBodies random(1);
    double worst = 0;
    int separated = 0, near = 0, overlapping = 0;
    for (int i = 0; i < 3000; ++i) {
        RandomPair pair(random, 12);
        ExactDistance exact = pair.ask();
        if (i % 2 == 0) {  // move to within a small gap, or a small overlap, of contact
            const double gap = std::ldexp(random.number(), -static_cast<int>(random.bits()() % 40));
            if (exact.distance > 0) pair.pose_b.translation += exact.separation * (1 - gap);
            exact = pair.ask();
        }
        const Result<Polyhedron> a = convex_hull(pair.a);
        const Result<Polyhedron> b = convex_hull(pair.b);
        if (!a || !b) continue;
        const double brute = brute_force_distance(*a, pair.pose_a, *b, pair.pose_b);
        worst = std::max(worst, std::abs(brute - exact.distance));
        const bool apart = exact.verdict == ExactVerdict::separated;
        separated += apart && exact.distance > 1e-3;
        near += apart && exact.distance <= 1e-3;
        overlapping += !apart;
    }
    std::printf("brute force: worst difference %.3g; separated %d, near %d, overlapping %d\n", worst,
                separated, near, overlapping);
    EXPECT_LT(worst, 1e-12);
    EXPECT_GT(separated, 300);
    EXPECT_GT(near, 300);
    EXPECT_GT(overlapping, 300);
}

TEST(ExactDistanceRandom, same_bits_under_swap_permutation_and_seed) {
    RandomBodies random(2);
    for (int i = 0; i < 500; ++i) {
        RandomPair pair(random, 40);
        const ExactDistance exact = pair.ask();
        expect_same(exact, *exact_distance(pair.b, pair.pose_b, pair.a, pair.pose_a), -1);
        expect_same(exact, pair.ask(exact.simplex));
        SimplexSeed nonsense;
        nonsense.size = 4;
        for (VertexPair& p : nonsense.pair) p = {static_cast<std::uint32_t>(random.bits()() % 60), 1};
        expect_same(exact, pair.ask(nonsense));
        std::shuffle(pair.a.begin(), pair.a.end(), random.bits());
        std::reverse(pair.b.begin(), pair.b.end());
        pair.b.push_back(pair.b.front());
        expect_same(exact, pair.ask());
    }
}

TEST(ExactDistanceRandom, same_bits_under_powers_of_two) {
    RandomBodies random(3);
    for (int i = 0; i < 200; ++i) {
        const RandomPair pair(random, 20);
        const ExactDistance exact = pair.ask();
        for (const int k : {-900, -60, -7, 1, 60, 900}) {
            RandomPair scaled = pair;
            const double factor = std::ldexp(1.0, k);
            scaled.scale(factor);
            expect_same(exact, scaled.ask(), factor);
        }
    }
}

TEST(ExactDistanceRandom, common_shift_changes_nothing) {
    RandomBodies random(4);
    for (int i = 0; i < 200; ++i) {
        RandomPair pair(random, 40);
        // Coordinates on a grid of 2^-20, so that the shifted translations are exact.
        const auto on_grid = [](double x) { return std::round(x * 0x1p20) * 0x1p-20; };
        for (Pose* pose : {&pair.pose_a, &pair.pose_b}) {
            pose->translation = pose->translation.unaryExpr(on_grid);
        }
        const ExactDistance exact = pair.ask();
        pair.shift({0x1p30, -0x1p31, 3 * 0x1p29});
        expect_same(exact, pair.ask());
    }
}

/// A sphere cut off at x = 0.6: many vertices in one face, exact ties before the rotation, ties
/// except for rounding after it. Scales, far-off vertices and flattening matrices as hard as they come.
Points cut_sphere(RandomBodies& random, std::vector<std::uint32_t>& face) {
    Points points = random.on_sphere(60);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (points[i].x() > 0.6) face.push_back(i);
        points[i].x() = std::min(points[i].x(), 0.6);
    }
    const double size = std::ldexp(1.0, static_cast<int>(random.bits()() % 1800) - 900);
    const Vec3d shift = std::ldexp(1.0, static_cast<int>(random.bits()() % 40)) * random.unit();
    for (Vec3d& v : points) v = size * (v + shift);
    return points;
}

TEST(ExactDistanceRandom, filter_never_loses_the_lowest_vertex) {
    RandomBodies random(6);
    std::size_t ties = 0, not_first = 0;
    for (int i = 0; i < 500; ++i) {
        std::vector<std::uint32_t> face;
        const Points points = cut_sphere(random, face);
        Pose pose{random.rotation(), random.unit()};
        if (i % 2 == 0) pose.rotation.row(1) *= 1e-9;
        ExactBody body(points, pose, ExactBody::unit_exponent(points, pose));
        if (face.size() < 3) continue;
        const IntegerVec corner = body.world(face[0]);
        IntegerVec direction = cross(body.world(face[1]) - corner, body.world(face[2]) - corner);
        for (int side = 0; side < 2; ++side, direction = -direction) {
            if (direction.is_zero()) continue;
            const std::uint32_t found = body.lowest(direction);
            const mpz_class height = dot(direction, body.world(found));
            for (std::uint32_t v = 0; v < 60; ++v) ASSERT_LE(height, dot(direction, body.world(v)));
            ties += body.filter().candidates(rounded_direction(direction)).size() > 1;
            not_first += body.filter().lowest(rounded_direction(direction)) != found;
        }
    }
    std::printf("filter: %zu scans with several candidates, %zu where double alone is wrong\n", ties,
                not_first);
    EXPECT_GT(ties, 200U);
    EXPECT_GT(not_first, 50U);
}

/// Division and square root of IEEE doubles are correctly rounded, so they are the oracle here.
TEST(Dyadic, rounds_like_the_processor) {
    RandomBodies random(7);
    int denormal = 0;
    for (int i = 0; i < 20000; ++i) {
        const double p = std::ldexp(static_cast<double>(random.bits()() >> 11), 0);
        const double q = static_cast<double>((random.bits()() >> (11 + i % 40)) + 1);
        const mpz_class n = scaled(p, 0), d = scaled(q, 0);
        EXPECT_EQ(rounded_quotient(n, d, 0), p / q);
        EXPECT_EQ(rounded_quotient(-n, d, 3), -8 * (p / q));
        EXPECT_EQ(rounded_root(n, 1, 0), std::sqrt(p));
        EXPECT_EQ(rounded_root(n * n, d * d, 0), p / q);
        const double small = p * 0x1p-1074;
        EXPECT_EQ(rounded_quotient(n, d, -1074), small / q);
        denormal += small / q < std::numeric_limits<double>::min();
    }
    EXPECT_GT(denormal, 5000);
    EXPECT_EQ(rounded_quotient(1, 1, 5000), std::numeric_limits<double>::infinity());
    EXPECT_EQ(rounded_quotient(1, 1, -5000), 0);
}

}  // namespace
}  // namespace edgewise::truth
