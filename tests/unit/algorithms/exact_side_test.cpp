// SPDX-License-Identifier: MIT
//
// The exact side of a plane and the exact normal of a triangle compared with rational arithmetic: points in
// the plane or on the line, and off it by no more than the last digit.
#include "edgewise/algorithms/penetration/expansion.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/scene/rng.hpp"

namespace edgewise {
namespace {

using Rational = std::array<mpq_class, 3>;

Rational minus(const Vec3d& a, const Vec3d& b) {
    Rational result;
    for (int i = 0; i < 3; ++i) result[i] = mpq_class(a[i]) - mpq_class(b[i]);
    return result;
}

Rational true_cross(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const Rational p = minus(b, a), q = minus(c, a);
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

int true_side(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& point) {
    const Rational normal = true_cross(a, b, c), r = minus(point, a);
    return sgn(mpq_class(r[0] * normal[0] + r[1] * normal[1] + r[2] * normal[2]));
}

/// In the plane of the others except for rounding; on a coarse lattice exactly.
Vec3d near_plane(scene::Rng& rng, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const double s = std::ldexp(std::round(rng.uniform(-8, 8)), -2);
    const double t = rng.below(3) == 0 ? 0 : std::ldexp(std::round(rng.uniform(-8, 8)), -2);
    Vec3d point = a + s * (b - a) + t * (c - a);
    if (rng.below(2) == 0) {
        const double last_digit = std::ldexp(1.0, -static_cast<int>(50 + rng.below(100)));
        point[static_cast<int>(rng.below(3))] += rng.below(2) == 0 ? last_digit : -last_digit;
    }
    return point;
}

TEST(ExactSide, IsTheSignOfTheDeterminant) {
    scene::Rng rng(1);
    int seen[3] = {}, doubtful = 0;
    for (int i = 0; i < 100000; ++i) {
        // Lattices of 4 to 53 bits, and corners of very different size.
        const double step = std::ldexp(1.0, -static_cast<int>(4 + rng.below(50)));
        Vec3d corner[3];
        for (Vec3d& p : corner) {
            const double size = i % 5 == 0 ? std::ldexp(1.0, -static_cast<int>(rng.below(80))) : 1;
            p = size * step * (rng.in_cube(1) / step).array().round();
        }
        const Vec3d& a = corner[0];
        const Vec3d &b = corner[1], &c = corner[2];
        const Vec3d point = i % 10 == 0 ? rng.in_cube(2) : near_plane(rng, a, b, c);
        const int truth = true_side(a, b, c, point);
        EXPECT_EQ(epa::side(a, b, c, point), truth);
        EXPECT_EQ(epa::exact_side(a, b, c, point), truth);
        ++seen[truth + 1];
        const Vec3d p = b - a, q = c - a, r = point - a;
        const double plain = dot(r, cross(p, q));
        doubtful += (plain > 0) - (plain < 0) != truth;
    }
    std::printf("exact side: %d below, %d in the plane, %d above; plain arithmetic wrong %d times\n", seen[0],
                seen[1], seen[2], doubtful);
    for (const int count : seen) EXPECT_GT(count, 1000);
    EXPECT_GT(doubtful, 1000);
}

/// In line except for their own rounding; or one step of a lattice of 52 bits off, which leaves an area of
/// 2^-104.
std::array<Vec3d, 3> sliver(scene::Rng& rng) {
    if (rng.below(4) == 0) {
        const double n = 0x1p52 - static_cast<double>(rng.below(1000));
        return {Vec3d::Zero(), 0x1p-52 * Vec3d(n, n - 1, n - 1), 0x1p-52 * Vec3d(n - 1, n - 2, n - 2)};
    }
    const Vec3d a = rng.in_cube(1);
    const Vec3d along = rng.uniform(0.1, 1) * rng.on_sphere();
    return {a, a + along, a + rng.uniform(-2, 2) * along};
}

TEST(ExactSide, NormalOfASliver) {
    scene::Rng rng(2);
    double worst = 0;
    int thinnest = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto [a, b, c] = sliver(rng);
        const Rational truth = true_cross(a, b, c);
        const Vec3d found = epa::exact_cross(a, b, c);
        for (int k = 0; k < 3; ++k) {
            const mpq_class error = mpq_class(found[k]) - truth[k];
            worst = std::max(
                worst, truth[k] == 0 ? std::abs(found[k]) : std::abs(mpq_class(error / truth[k]).get_d()));
        }
        if (max_abs(found) == 0) continue;
        thinnest += max_abs(found) < 0x1p-96;
        const Vec3d normal = epa::triangle_normal(a, b, c), expected = found / max_abs(found);
        EXPECT_LT(norm(Vec3d(normal - expected / norm(expected))), 1e-14);
    }
    std::printf("exact normal: worst component %.2g, %d thinner than 2^-96\n", worst, thinnest);
    EXPECT_LT(worst, 1e-15);
    EXPECT_GT(thinnest, 1000);
}

}  // namespace
}  // namespace edgewise
