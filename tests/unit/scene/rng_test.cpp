// SPDX-License-Identifier: MIT
//
// The generator against its authors' reference numbers and against what uniform means.
#include "edgewise/scene/rng.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "edgewise/geometry/pose.hpp"

namespace edgewise::scene {
namespace {

/// xoshiro256** written down a second time, straight from its definition.
struct Reference {
    std::array<std::uint64_t, 4> s;
    static std::uint64_t rotl(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }
    std::uint64_t next() {
        const std::uint64_t result = rotl(s[1] * 5, 7) * 9;
        const std::uint64_t t = s[1] << 17;
        s[2] ^= s[0], s[3] ^= s[1], s[1] ^= s[2], s[0] ^= s[3], s[2] ^= t;
        s[3] = rotl(s[3], 45);
        return result;
    }
};

TEST(Rng, FollowsItsDefinitionFromThePublishedSplitMixNumbers) {
    // The first four outputs of SplitMix64 from seed 1234567, as its authors publish them.
    Reference reference{
        {6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U}};
    Rng rng(1234567);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(rng.next(), reference.next()) << "draw " << i;
}

TEST(Rng, OneSeedOneSequence) {
    Rng a(7), b(7), other(8);
    int equal_to_other = 0;
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t x = a.next();
        ASSERT_EQ(x, b.next());
        equal_to_other += x == other.next();
    }
    EXPECT_EQ(equal_to_other, 0);
}

TEST(Rng, UniformFillsTheUnitInterval) {
    Rng rng(1);
    constexpr int draws = 200000;
    double sum = 0, squares = 0, low = 1, high = 0;
    for (int i = 0; i < draws; ++i) {
        const double x = rng.uniform();
        ASSERT_GE(x, 0);
        ASSERT_LT(x, 1);
        ASSERT_EQ(x * 0x1p53, std::floor(x * 0x1p53)) << "not a multiple of 2^-53";
        sum += x, squares += x * x, low = std::min(low, x), high = std::max(high, x);
    }
    std::printf("uniform: mean %.5f, mean square %.5f, range %.2e .. 1 - %.2e\n", sum / draws,
                squares / draws, low, 1 - high);
    EXPECT_NEAR(sum / draws, 1.0 / 2, 5 * std::sqrt(1.0 / 12 / draws));
    EXPECT_NEAR(squares / draws, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / draws));
    EXPECT_LT(low, 1e-4);
    EXPECT_GT(high, 1 - 1e-4);
}

TEST(Rng, BelowIsUnbiasedAlsoWhereAModuloWouldNotBe) {
    Rng rng(2);
    constexpr int draws = 60000;
    std::array<int, 6> seen{};
    for (int i = 0; i < draws; ++i) ++seen.at(rng.below(6));
    for (const int count : seen) EXPECT_NEAR(count, draws / 6, 5 * std::sqrt(draws / 6.0));

    // Below 3 * 2^62 a plain modulo would give the lowest third twice as often as the others: a half, not a
    // third.
    constexpr std::uint64_t third = std::uint64_t{1} << 62;
    int lowest = 0;
    for (int i = 0; i < draws; ++i) lowest += rng.below(3 * third) < third;
    std::printf("below(3 * 2^62): share of the lowest third %.4f (a biased draw: 0.5)\n",
                1.0 * lowest / draws);
    EXPECT_NEAR(lowest, draws / 3, 5 * std::sqrt(draws * 2 / 9.0));
    for (int i = 0; i < 100; ++i) EXPECT_EQ(rng.below(1), 0U);
}

TEST(Rng, PointsOfTheBallAndTheSphere) {
    Rng rng(3);
    constexpr int draws = 100000;
    int inner = 0;
    Vec3d ball = Vec3d::Zero(), sphere = Vec3d::Zero();
    double worst = 0;
    for (int i = 0; i < draws; ++i) {
        const Vec3d p = rng.in_ball();
        ASSERT_LE(squared_norm(p), 1);
        inner += norm(p) <= 0.5;
        ball += p;
        const Vec3d q = rng.on_sphere();
        worst = std::max(worst, std::abs(norm(q) - 1));
        sphere += q;
    }
    std::printf("ball: share within half the radius %.4f (1/8); sphere: worst |length - 1| %.1e\n",
                1.0 * inner / draws, worst);
    EXPECT_NEAR(inner, draws / 8, 5 * std::sqrt(draws * 7 / 64.0));
    EXPECT_LT(max_abs(ball) / draws, 5 * std::sqrt(1.0 / 5 / draws));
    EXPECT_LT(max_abs(sphere) / draws, 5 * std::sqrt(1.0 / 3 / draws));
    EXPECT_LT(worst, 4e-16);
}

TEST(Rng, RotationsAreOrthogonalAndUniform) {
    Rng rng(4);
    constexpr int draws = 100000;
    double worst = 0, worst_determinant = 0, trace = 0, trace_square = 0;
    for (int i = 0; i < draws; ++i) {
        const Mat3d r = rng.rotation();
        worst = std::max(worst, ortho_error(r));
        const Vec3d x = r.col(0), y = r.col(1), z = r.col(2);
        worst_determinant = std::max(worst_determinant, std::abs(dot(cross(x, y), z) - 1));
        const double t = r(0, 0) + r(1, 1) + r(2, 2);
        trace += t, trace_square += t * t;
    }
    // Over all rotations the trace has mean 0 and mean square 1; turned angles drawn evenly would give 1
    // and 3.
    std::printf(
        "rotations: worst ortho error %.1e, determinant - 1 %.1e, trace mean %.4f, mean square %.4f\n", worst,
        worst_determinant, trace / draws, trace_square / draws);
    EXPECT_LT(worst, 4e-15);
    EXPECT_LT(worst_determinant, 4e-15);
    EXPECT_NEAR(trace / draws, 0, 0.02);
    EXPECT_NEAR(trace_square / draws, 1, 0.03);
}

TEST(Rng, GoldenDoubles) {
    Rng rng(42);
    std::uint64_t hash = 0xcbf29ce484222325;
    for (int i = 0; i < 1000; ++i) {
        const Vec3d p = rng.on_sphere();
        for (int axis = 0; axis < 3; ++axis) {
            std::uint64_t bits = 0;
            const double x = p[axis];
            static_assert(sizeof bits == sizeof x);
            std::memcpy(&bits, &x, sizeof x);
            hash = (hash ^ bits) * 0x100000001b3;
        }
    }
    std::printf("hash of 1000 directions: %016llx\n", static_cast<unsigned long long>(hash));
    EXPECT_EQ(hash, 0xb8e48da0e6632913U);
}

}  // namespace
}  // namespace edgewise::scene
