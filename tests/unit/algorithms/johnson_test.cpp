// SPDX-License-Identifier: MIT
//
// Johnson's sub-distance algorithm, and its cofactors without his search, compared with the exact distance of
// the simplex's points from the origin: simplices of every size and every awkward kind, in double and in
// single.
#include "edgewise/algorithms/johnson.hpp"

#include <gtest/gtest.h>

#include <bitset>
#include <cstdio>
#include <string>

#include "edgewise/algorithms/cofactors.hpp"
#include "edgewise/algorithms/sub_distance.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise {
namespace {

using Corners = SimplexPoints<double>;

Corners at_random(scene::Rng& rng) {
    const Vec3d shift = rng.in_cube(1.5);
    Corners w;
    for (Vec3d& p : w) p = rng.in_cube(1) + shift;
    return w;
}

double tiny(scene::Rng& rng) { return std::ldexp(rng.uniform(-1, 1), -static_cast<int>(rng.below(45))); }

/// The third point almost on the line of the first two, the fourth near a point of their triangle.
Corners sliver(scene::Rng& rng) {
    Corners w = at_random(rng);
    w[2] = w[0] + rng.uniform(-0.5, 1.5) * (w[1] - w[0]) + tiny(rng) * rng.on_sphere();
    w[3] = w[0] + rng.uniform() * (w[2] - w[0]) + rng.uniform() * (w[1] - w[0]) + tiny(rng) * rng.on_sphere();
    return w;
}

/// All four almost in a plane; the origin often near it.
Corners flat(scene::Rng& rng) {
    Corners w = at_random(rng);
    const Vec3d normal = rng.on_sphere();
    const double height = rng.below(2) == 0 ? tiny(rng) : rng.uniform();
    for (Vec3d& p : w) p += (height + 1e-3 * tiny(rng) - dot(normal, p)) * normal;
    return w;
}

/// Points of a small lattice: equal points, collinear and coplanar ones, the origin in a corner, edge or
/// face.
Corners lattice(scene::Rng& rng) {
    Corners w;
    for (Vec3d& p : w) p = rng.in_cube(2).array().round();
    return w;
}

/// Moved so that the origin is next to some point of the simplex.
Corners near_contact(scene::Rng& rng) {
    Corners w = at_random(rng);
    Vec3d place = Vec3d::Zero();
    double sum = 0;
    for (const Vec3d& p : w) {
        const double weight = rng.below(2) == 0 ? 0 : rng.uniform();
        place += weight * p;
        sum += weight;
    }
    if (sum > 0) place /= sum;
    // One draw a statement: compilers evaluate operands in either order.
    const Vec3d direction = rng.on_sphere();
    place += tiny(rng) * direction;
    for (Vec3d& p : w) p -= place;
    return w;
}

struct Kind {
    const char* name;
    Corners (*make)(scene::Rng&);
};

constexpr Kind kinds[] = {
    {"random", at_random},          {"slivers", sliver}, {"flat", flat}, {"lattice", lattice},
    {"near contact", near_contact},
};

/// Over the largest coordinate. Weights are worse than the point: close to contact they cancel.
template <class Scalar>
constexpr double error_allowed = 32 * static_cast<double>(Tolerance<Scalar>::eps);
template <class Scalar>
constexpr double witness_allowed = 8192 * static_cast<double>(Tolerance<Scalar>::eps);

struct Seen {
    std::bitset<16> subsets;
    double error = 0, weights = 0, sum = 0;
    int backups = 0, missed = 0;
    int untold = 0;  ///< missed, and neither backup nor thin: GJK takes such an answer as it is
};

double exact_from_origin(const Corners& w, int count) {
    const Vec3d origin = Vec3d::Zero();
    const auto exact =
        truth::exact_distance(std::span(w).first(static_cast<std::size_t>(count)), {}, {&origin, 1}, {});
    EXPECT_TRUE(exact) << exact.error;
    return exact ? exact->distance : 0;
}

/// Johnson's search.
struct BySearch {
    static constexpr const char* name = "johnson";
    template <class Scalar>
    static ClosestOfSimplex<Scalar> closest(const SimplexPoints<Scalar>& w, int count) {
        return Johnson<Scalar>(w, count).closest();
    }
};

/// The cofactors' signs, as GJK uses them.
struct BySigns {
    static constexpr const char* name = "cofactors";
    template <class Scalar>
    static ClosestOfSimplex<Scalar> closest(const SimplexPoints<Scalar>& w, int count) {
        ClosestOfSimplex<Scalar> found;
        find_closest(w, count, false, found);
        return found;
    }
};

template <class Solver, class Scalar>
void ask(Corners w, int count, Seen& seen) {
    SimplexPoints<Scalar> stored;
    double size = 0;
    for (int i = 0; i < 4; ++i) {
        if (sizeof(Scalar) == sizeof(float)) w[i] = to_single(w[i]);
        stored[i] = w[i].cast<Scalar>();
        if (i < count) size = std::max(size, max_abs(w[i]));
    }
    const double exact = exact_from_origin(w, count);
    const auto closest = Solver::closest(stored, count);
    ASSERT_NE(closest.members, 0);
    seen.subsets.set(closest.members);
    seen.backups += closest.backup;
    const bool contact = closest.members == 15;
    const double found = contact ? 0 : static_cast<double>(norm(closest.point));
    const double error = size > 0 ? std::abs(found - exact) / size : 0;
    seen.error = std::max(seen.error, error);
    seen.missed += error > error_allowed<Scalar>;
    seen.untold += error > error_allowed<Scalar> && !closest.thin && !closest.backup;

    Scalar sum = 0;
    Vec3<Scalar> weighted = Vec3<Scalar>::Zero();
    for (int i = 0; i < count; ++i) {
        if (!(closest.members >> i & 1)) continue;
        EXPECT_GT(closest.weight[i], 0);
        sum += closest.weight[i];
        weighted += closest.weight[i] * stored[i];
    }
    seen.sum = std::max(seen.sum, std::abs(static_cast<double>(sum) - 1));
    const auto off = static_cast<double>(norm(Vec3<Scalar>(weighted - closest.point)));
    if (!contact && size > 0) seen.weights = std::max(seen.weights, off / size);
}

template <class Solver, class Scalar>
void ask_all() {
    constexpr bool single = sizeof(Scalar) == sizeof(float);
    scene::Rng rng(1);
    std::bitset<16> subsets;
    for (const Kind& kind : kinds) {
        Seen seen;
        for (int i = 0; i < 20000; ++i) {
            const int count = 1 + static_cast<int>(rng.below(4));
            ask<Solver, Scalar>(kind.make(rng), count, seen);
        }
        std::printf(
            "%s %s, %s: worst error %.3g, witness %.3g, sum of weights %.3g; %d backups, "
            "%d missed, %d of them untold\n",
            Solver::name, single ? "single" : "double", kind.name, seen.error, seen.weights, seen.sum,
            seen.backups, seen.missed, seen.untold);
        // In single precision three almost collinear points have cofactors that are nothing but noise, and
        // all three may be positive: some thin triangle then answers with weights of no meaning, and GJK asks
        // in double.
        EXPECT_EQ(single ? seen.untold : seen.missed, 0) << kind.name;
        EXPECT_LE(seen.weights, witness_allowed<Scalar>) << kind.name;
        EXPECT_LE(seen.sum, 4 * static_cast<double>(Tolerance<Scalar>::eps)) << kind.name;
        subsets |= seen.subsets;
    }
    for (std::size_t mask = 1; mask < 16; ++mask) EXPECT_TRUE(subsets[mask]) << "subset " << mask;
}

TEST(Johnson, DoubleIsTheNearestPointOfEverySimplex) { ask_all<BySearch, double>(); }

TEST(Johnson, SingleIsTheNearestPointOfEverySimplex) { ask_all<BySearch, float>(); }

TEST(Cofactors, InDoubleTellTheNearestPointOfEverySimplex) { ask_all<BySigns, double>(); }

TEST(Cofactors, InSingleTellTheNearestPointOfEverySimplex) { ask_all<BySigns, float>(); }

/// Where a simplex is no hard case, signs find the subset and the weights of the search, to the bit; also
/// with the newest point known.
TEST(Cofactors, AgreeWithTheSearchToTheBit) {
    scene::Rng rng(3);
    std::bitset<16> subsets;
    for (int i = 0; i < 100000; ++i) {
        const int count = 1 + static_cast<int>(rng.below(4));
        const Corners w = at_random(rng);
        const auto searched = BySearch::closest(w, count);
        const bool newest = searched.members >> (count - 1) & 1;
        ClosestOfSimplex<double> found;
        find_closest(w, count, newest, found);
        ASSERT_EQ(found.members, searched.members);
        if (found.members != 15) {
            EXPECT_EQ(found.point, searched.point);
        }
        for (int k = 0; k < count; ++k) EXPECT_EQ(found.weight[k], searched.weight[k]);
        EXPECT_EQ(found.thin, searched.thin);
        if (newest) subsets.set(found.members);
    }
    // All that may hold a newest point.
    for (std::size_t mask = 1; mask < 16; ++mask) EXPECT_TRUE(subsets[mask]) << "subset " << mask;
}

/// Asked for a subset with a point that it does not rest on, every subset is tried before an answer is given.
TEST(Cofactors, AWrongNewestPointIsNoWrongAnswer) {
    scene::Rng rng(4);
    int wrong = 0;
    for (int i = 0; i < 10000; ++i) {
        const Corners w = at_random(rng);
        const auto searched = BySearch::closest(w, 3);
        if (searched.members & 4) continue;
        ClosestOfSimplex<double> found;
        find_closest(w, 3, true, found);
        EXPECT_EQ(found.members, searched.members);
        EXPECT_EQ(found.point, searched.point);
        ++wrong;
    }
    EXPECT_GT(wrong, 1000);
}

/// Three corners on a line, or almost: cofactors of their triangle are noise. A query that started from such
/// a simplex once ended at 0.026 where the distance was 7.5e-6.
TEST(Johnson, TakesASideOfATriangleWithCollinearCornersInWiderArithmetic) {
    scene::Rng rng(6);
    double worst = 0;
    int triangles = 0;
    for (int i = 0; i < 100000; ++i) {
        const double x = std::ldexp(rng.uniform(-1, 1), -static_cast<int>(rng.below(30)));
        const double y = std::ldexp(rng.uniform(-1, 1), -static_cast<int>(rng.below(30)));
        Corners w;
        for (Vec3d& p : w) p = Vec3d(x, y, rng.uniform(-1, 1));
        if (rng.below(2) == 0) w[1 + rng.below(3)].x() += tiny(rng);
        const int count = 3 + static_cast<int>(rng.below(2));
        SimplexPoints<DoubleDouble> wide;
        for (int k = 0; k < count; ++k) wide[k] = cast<DoubleDouble>(w[k]);
        const auto found = closest_in_wide(wide, count, SubDistanceSolver::cofactors);
        const double distance = std::sqrt(static_cast<double>(squared_norm(found.point)));
        worst = std::max(worst, std::abs(distance - exact_from_origin(w, count)));
        triangles += is_triangle(found.members);
    }
    std::printf("collinear corners: worst error %.3g, %d closest points in triangles\n", worst, triangles);
    EXPECT_LE(worst, 1e-15);
    EXPECT_GT(triangles, 100);
}

}  // namespace
}  // namespace edgewise
