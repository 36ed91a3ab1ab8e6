// SPDX-License-Identifier: MIT
//
// A certificate must hold the exact distance whatever the answer claims: good, slightly wrong, or garbage; on
// random and hard families, for the stored and for the given bodies. The exact result is not a double but the
// rational square that exact_distance rounds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>

#include "edgewise/truth/certificate.hpp"
#include "edgewise/truth/dyadic.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

using Pair = PosedPoints;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Closest points and direction that an answer claims.
struct Claim {
    std::vector<std::uint32_t> on_a, on_b;
    Vec3d direction = Vec3d::Zero();

    [[nodiscard]] Certificate certify(const Pair& pair) const {
        const auto result =
            edgewise::truth::certify(pair.a, pair.pose_a, pair.b, pair.pose_b, on_a, on_b, direction);
        EXPECT_TRUE(result) << result.error;
        return result ? *result : Certificate{-1, -1};
    }
};

struct Truth {
    mpq_class square;
    Claim claim;  ///< the true one, as well as doubles can say it
    ExactVerdict verdict = ExactVerdict::separated;
};

mpq_class power_of_two(long exponent) {
    mpz_class power = 1;
    power <<= static_cast<mp_bitcnt_t>(std::abs(exponent));
    return exponent < 0 ? mpq_class(1, power) : mpq_class(power);
}

Truth truth_of(const Pair& pair) {
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
    if (sgn(nearest.height) == 0) return truth;
    truth.square = mpq_class(nearest.height * nearest.height, dot(nearest.direction, nearest.direction));
    truth.square.canonicalize();
    truth.square *= power_of_two(2 * bodies.unit);
    truth.claim.direction = rounded_direction(nearest.direction);
    return truth;
}

::testing::AssertionResult holds(const Certificate& c, const mpq_class& square) {
    const bool below = c.lower >= 0 && mpq_class(c.lower) * mpq_class(c.lower) <= square;
    const bool above = std::isinf(c.upper) || mpq_class(c.upper) * mpq_class(c.upper) >= square;
    if (below && above) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << c.lower << " to " << c.upper << " misses " << std::sqrt(square.get_d());
}

double log_uniform(RandomBodies& random, int low, int high) {
    const double mantissa = 1 + std::abs(random.number());
    return std::ldexp(mantissa,
                      low + static_cast<int>(random.bits()() % static_cast<unsigned>(high - low + 1)));
}

Pair round_pair(RandomBodies& random, double apart) {
    const auto points = [&] { return random.on_sphere(4 + static_cast<int>(random.bits()() % 36)); };
    Pair pair{points(), points(), {random.rotation(), random.unit()}, {}};
    pair.pose_b = {random.rotation(), pair.pose_a.translation + apart * random.unit()};
    return pair;
}

/// Moved along the separation until a gap, or a small overlap, is left.
Pair grazing(RandomBodies& random) {
    Pair pair = round_pair(random, 2.5);
    const auto exact = exact_distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
    const double left = random.number() * log_uniform(random, -52, -1);
    pair.pose_b.translation += (1 - left) * exact->separation;
    return pair;
}

struct Family {
    const char* name;
    std::function<Pair(RandomBodies&)> make;
    int overlapping = 0;  ///< at least this many of 400
};

/// Two boxes face to face, one tilted by as little as a rounding step.
Pair nearly_parallel(RandomBodies& random) {
    Pair pair{unit_box, unit_box, {random.rotation(), random.unit()}, {}};
    const double tilt = log_uniform(random, -53, -4);
    Mat3d turn;
    turn << 1, -tilt, 0, tilt, 1, tilt, 0, -tilt, 1;
    for (int i = 0; i < 3; ++i) {
        const Vec3d column = turn.col(i);
        pair.pose_b.rotation.col(i) = multiply(pair.pose_a.rotation, column);
    }
    const double gap = log_uniform(random, -50, -1);
    const Vec3d shift(1 + gap, 0.5 * random.number(), 0.5 * random.number());
    pair.pose_b.translation = pair.pose_a.translation + multiply(pair.pose_a.rotation, shift);
    return pair;
}

Pair on_a_lattice(RandomBodies& random) {
    const auto step = [&] { return 0.5 * static_cast<double>(random.bits()() % 6) - 1; };
    const double x = step(), y = step(), z = step();
    return {unit_box, unit_box, {}, moved({x, y, z})};
}

Pair far_off(RandomBodies& random) {
    Pair pair = grazing(random);
    const Vec3d shift = log_uniform(random, 10, 40) * random.unit();
    if (random.number() < 0) {
        pair.shift(shift);
        return pair;
    }
    for (Vec3d& v : pair.a) v += shift;
    pair.pose_a.translation -= multiply(pair.pose_a.rotation, shift);
    return pair;
}

Pair unequal(RandomBodies& random) {
    Pair pair = round_pair(random, 1);
    const double size = log_uniform(random, -27, 27);
    for (Vec3d& v : pair.a) v *= size;
    pair.pose_b.translation = pair.pose_a.translation + (1 + size) * 1.1 * random.unit();
    return pair;
}

Pair skewed(RandomBodies& random) {
    Pair pair = grazing(random);
    for (Pose* pose : {&pair.pose_a, &pair.pose_b}) {
        for (double& entry : pose->rotation.reshaped()) entry += 1e-7 * random.number();
    }
    return pair;
}

Pair needles(RandomBodies& random) {
    Pair pair = round_pair(random, 1);
    const double thin = log_uniform(random, -30, -3);
    for (Points* points : {&pair.a, &pair.b}) {
        for (Vec3d& v : *points) v = {v.x(), thin * v.y(), thin * v.z()};
    }
    return pair;
}

Pair scaled(RandomBodies& random, double factor) {
    Pair pair = grazing(random);
    pair.scale(factor);
    return pair;
}

std::vector<Family> families() {
    return {{"random", [](RandomBodies& r) { return round_pair(r, 1.5 * (1 + r.number())); }, 100},
            {"grazing", grazing, 50},
            {"nearly parallel", nearly_parallel, 0},
            {"lattice", on_a_lattice, 30},
            {"far off", far_off, 20},
            {"unequal", unequal, 0},
            {"skewed", skewed, 30},
            {"needles", needles, 0},
            {"denormal", [](RandomBodies& r) { return scaled(r, 0x1p-1050); }, 50},
            {"huge", [](RandomBodies& r) { return scaled(r, 0x1p+1000); }, 50}};
}

/// Nearly right: a feature short of its last vertex, and a direction off by up to a thousandth.
Claim shaken(RandomBodies& random, Claim claim) {
    const double step = log_uniform(random, -50, -10);
    if (claim.on_a.size() > 1) claim.on_a.pop_back();
    claim.direction += step * random.unit();
    return claim;
}

Claim garbage(RandomBodies& random) {
    constexpr double odd[] = {nan, infinity, -infinity, 0, -1, 1e308, 5e-324, -5e-324, 1, 1e-17};
    const auto number = [&] { return random.number() < 0 ? random.number() : odd[random.bits()() % 10]; };
    Claim claim;
    const auto count = random.bits()() % 6;
    for (std::size_t i = 0; i < count; ++i) {
        claim.on_a.push_back(static_cast<std::uint32_t>(random.bits()() % 42));
        claim.on_b.push_back(static_cast<std::uint32_t>(random.bits()() % 42));
    }
    const double x = number(), y = number(), z = number();
    claim.direction = {x, y, z};
    return claim;
}

/// Like that of the accuracy band, but without squares, which huge and tiny numbers do not survive.
double scale_of(const Pair& pair) {
    double scale = max_abs(Vec3d(pair.pose_b.translation - pair.pose_a.translation));
    for (const Points* points : {&pair.a, &pair.b}) {
        for (const Vec3d& v : *points) scale = std::max(scale, max_abs(v));
    }
    return scale;
}

struct Widths {
    double good = 0, shaken = 0;
    int overlapping = 0, proved = 0, useful_garbage = 0;

    void add(RandomBodies& random, const Pair& pair) {
        const Truth truth = truth_of(pair);
        const double scale = scale_of(pair);
        const auto width = [&](const Certificate& c) {
            EXPECT_TRUE(holds(c, truth.square));
            // The last places of denormals are as wide as they are.
            return std::max(0.0, c.width() - 1e-323) / scale;
        };
        const Certificate best = truth.claim.certify(pair);
        good = std::max(good, width(best));
        shaken = std::max(shaken, width(edgewise::truth::shaken(random, truth.claim).certify(pair)));
        overlapping += truth.verdict == ExactVerdict::overlapping;
        proved += truth.square == 0 && best.upper == 0;
        const Certificate poor = garbage(random).certify(pair);
        EXPECT_TRUE(holds(poor, truth.square));
        useful_garbage += poor.lower > 0;
    }
};

Widths measure(const Family& family, RandomBodies& random) {
    Widths widths;
    for (int i = 0; i < 400; ++i) widths.add(random, family.make(random));
    std::printf(
        "%-16s width/scale: good %.2g, shaken %.2g; overlapping %d, contact proved %d, garbage with a lower "
        "bound %d\n",
        family.name, widths.good, widths.shaken, widths.overlapping, widths.proved, widths.useful_garbage);
    return widths;
}

TEST(CertificateFamilies, hold_the_exact_distance) {
    RandomBodies random(31);
    for (const Family& family : families()) {
        const Widths widths = measure(family, random);
        EXPECT_LE(widths.good, 5e-16) << family.name;
        EXPECT_GT(widths.shaken, widths.good) << family.name;
        EXPECT_GE(widths.overlapping, family.overlapping) << family.name;
        EXPECT_GE(widths.proved, widths.overlapping) << family.name;
        EXPECT_GT(widths.useful_garbage, 0) << family.name;
    }
}

Points stored(const Points& given, bool single) {
    Points result = given;
    for (Vec3d& v : result) {
        for (int i = 0; i < 3; ++i)
            v[i] = single ? double{static_cast<float>(v[i])} : std::round(v[i] * 64) / 64;
    }
    return result;
}

TEST(CertificateFamilies, widened_holds_the_distance_of_the_given_bodies) {
    RandomBodies random(32);
    for (const bool single : {true, false}) {
        int missed = 0;
        double worst = 0;
        for (int i = 0; i < 400; ++i) {
            const Pair given = i % 2 == 0 ? grazing(random) : round_pair(random, 3);
            const Pair rounded{stored(given.a, single), stored(given.b, single), given.pose_a, given.pose_b};
            const Certificate narrow = truth_of(rounded).claim.certify(rounded);
            const Certificate wide =
                widen(narrow, representation_error(given.a, rounded.a, given.pose_a.rotation),
                      representation_error(given.b, rounded.b, given.pose_b.rotation));
            const Truth truth = truth_of(given);
            EXPECT_TRUE(holds(wide, truth.square));
            missed += !holds(narrow, truth.square);
            worst = std::max(worst, wide.width());
        }
        std::printf("stored in %s: %d of 400 miss the given distance unwidened, worst width %.2g\n",
                    single ? "single" : "1/64ths", missed, worst);
        EXPECT_GT(missed, 200);
        EXPECT_LT(worst, single ? 1e-6 : 0.1);
    }
}

}  // namespace
}  // namespace edgewise::truth
