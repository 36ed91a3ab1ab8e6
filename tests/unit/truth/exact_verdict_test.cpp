// SPDX-License-Identifier: MIT
//
// Exact verdicts and depths on tiny integer bodies, where contact of every kind is common, against plain
// enumeration in machine integers. Verdicts: the normals n with n.w >= 0 for all points w of A - B form a
// cone, and if the points span space its extreme rays are among the cross products of pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "edgewise/truth/exact_distance.hpp"
#include "edgewise/truth/exact_proof.hpp"
#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

using Whole = Vec3<long>;

std::vector<Whole> difference(const Points& a, const Points& b) {
    std::vector<Whole> result;
    for (const Vec3d& p : a) {
        for (const Vec3d& q : b) result.push_back(Vec3d(p - q).cast<long>());
    }
    return result;
}

/// Signs of n.w over all points: the least of them, -1, 0 or 1.
int lowest_side(const Whole& n, const std::vector<Whole>& points) {
    int least = 1;
    for (const Whole& w : points) {
        const long height = dot(n, w);
        least = std::min(least, (height > 0) - (height < 0));
    }
    return least;
}

struct Enumeration {
    bool spans_space = false;
    ExactVerdict verdict = ExactVerdict::overlapping;
};

/// Separated if the middle of the cone is positive on every point, overlapping if there is no cone.
Enumeration enumerate(const std::vector<Whole>& points) {
    Enumeration result;
    Whole middle = Whole::Zero();
    for (const Whole& v : points) {
        for (const Whole& w : points) {
            const Whole n = cross(v, w);
            if (n.isZero()) continue;
            for (const Whole& x : points) result.spans_space |= dot(n, x) != 0;
            if (lowest_side(n, points) >= 0) middle += n;
        }
    }
    if (middle.isZero()) return result;
    result.verdict = lowest_side(middle, points) > 0 ? ExactVerdict::separated : ExactVerdict::touching;
    return result;
}

TEST(ExactVerdict, agrees_with_enumeration_on_a_grid) {
    RandomBodies random(8);
    int seen[3] = {};
    int touching_by_size[5] = {}, overlapping_by_size[5] = {};
    for (int i = 0; i < 6000; ++i) {
        const Points a = random.on_grid(2 + random.bits()() % 5);
        const Points b = random.on_grid(2 + random.bits()() % 5);
        const Enumeration expected = enumerate(difference(a, b));
        if (!expected.spans_space) continue;
        const ExactDistance exact = *exact_distance(a, {}, b, {});
        ASSERT_EQ(exact.verdict, expected.verdict) << "pair " << i;
        ++seen[static_cast<int>(exact.verdict)];
        touching_by_size[exact.simplex.size] += exact.verdict == ExactVerdict::touching;
        overlapping_by_size[exact.simplex.size] += exact.verdict == ExactVerdict::overlapping;
    }
    std::printf(
        "separated %d, touching %d (simplex of 1, 2, 3: %d %d %d), overlapping %d (1 to 4: %d %d %d %d)\n",
        seen[0], seen[1], touching_by_size[1], touching_by_size[2], touching_by_size[3], seen[2],
        overlapping_by_size[1], overlapping_by_size[2], overlapping_by_size[3], overlapping_by_size[4]);
    EXPECT_GT(seen[0], 300);
    for (int size = 1; size <= 3; ++size) EXPECT_GT(touching_by_size[size], 20) << size;
    for (int size = 1; size <= 4; ++size) EXPECT_GT(overlapping_by_size[size], 20) << size;
}

/// Cubes on a decimal lattice, 0.05 apart: the first guess in double holds the origin in a flat simplex,
/// which the integers then see otherwise. (A guess that already held the origin once took in another point
/// and was lost.)
TEST(ExactVerdict, cubes_on_a_decimal_lattice) {
    const Points cube = box({-1, -1, -1}, {1, 1, 1});
    RandomBodies random(9);
    const auto place = [&] { return 0.05 * (static_cast<double>(random.bits()() % 161) - 80); };
    int separated = 0, contact = 0;
    for (int i = 0; i < 20000; ++i) {
        const double x = place(), y = place(), z = place();
        const double gap = std::max({std::abs(x), std::abs(y), std::abs(z)}) - 2;
        const auto exact = exact_distance(cube, {}, cube, moved({x, y, z}));
        ASSERT_TRUE(exact) << exact.error;
        const bool right = (exact->verdict == ExactVerdict::separated) == (gap > 0);
        ASSERT_TRUE(right || std::abs(gap) < 1e-9) << "pair " << i;
        ++(gap > 0 ? separated : contact);
    }
    EXPECT_GT(separated, 1000);
    EXPECT_GT(contact, 1000);
}

/// The least h^2 / n.n over all planes through three points of A - B that bound it; h counts from the origin.
struct Quotient {
    long top = 1;
    long bottom = 0;
};

Quotient least_quotient(const std::vector<Whole>& points) {
    Quotient least;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            for (std::size_t k = j + 1; k < points.size(); ++k) {
                const Whole n = cross(Whole(points[j] - points[i]), Whole(points[k] - points[i]));
                if (n.isZero()) continue;
                const long height = dot(n, points[i]);
                long low = 0, high = 0;
                for (const Whole& p : points) {
                    low = std::min(low, dot(n, p) - height);
                    high = std::max(high, dot(n, p) - height);
                }
                if (low < 0 && high > 0) continue;
                const long square = dot(n, n);
                if (height * height * least.bottom < least.top * square || least.bottom == 0)
                    least = {height * height, square};
            }
        }
    }
    return least;
}

TEST(ExactDepth, agrees_with_enumeration_on_a_grid) {
    RandomBodies random(21);
    int deep = 0, touching = 0, flat = 0;
    for (int i = 0; i < 2500; ++i) {
        const Points a = random.on_grid(1 + random.bits()() % 6);
        const Points b = random.on_grid(1 + random.bits()() % 5);
        const Result<ExactDepth> exact = exact_depth(a, {}, b, {});
        if (!exact) continue;
        const Quotient least = least_quotient(difference(a, b));
        const double quotient =
            least.bottom == 0 ? 0 : static_cast<double>(least.top) / static_cast<double>(least.bottom);
        ASSERT_NEAR(exact->depth, std::sqrt(quotient), 4e-16 * exact->depth) << "pair " << i;
        deep += exact->depth > 0;
        touching += exact->depth == 0 && least.bottom > 0;
        flat += least.bottom == 0;
    }
    std::printf("grid: %d deep, %d touching or in a plane, %d on a line\n", deep, touching, flat);
    EXPECT_GT(deep, 500);
    EXPECT_GT(touching, 100);
    EXPECT_GT(flat, 3);
}

}  // namespace
}  // namespace edgewise::truth
