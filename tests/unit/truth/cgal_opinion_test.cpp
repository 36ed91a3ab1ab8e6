// SPDX-License-Identifier: MIT
//
// A second opinion on the exact oracle, from CGAL, with nothing in common but GMP: distances from its
// quadratic programme (Polytope_distance_d), depths from its hull of all vertex differences (convex_hull_3).
// World positions are computed here in rationals. Built where CGAL is found.
#include <CGAL/Cartesian.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polytope_distance_d.h>
#include <CGAL/Polytope_distance_d_traits_3.h>
#include <CGAL/convex_hull_3.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "edgewise/truth/exact_distance.hpp"
#include "edgewise/truth/exact_proof.hpp"
#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

using Rational = CGAL::Gmpq;
using Kernel = CGAL::Cartesian<Rational>;
using Point = Kernel::Point_3;
using DistanceTraits = CGAL::Polytope_distance_d_traits_3<Kernel>;

using Pair = PosedPoints;

std::vector<Point> world_points(const Points& vertices, const Pose& pose) {
    std::vector<Point> result;
    for (const Vec3d& v : vertices) {
        std::array<Rational, 3> x;
        for (int i = 0; i < 3; ++i) {
            x[i] = Rational(pose.translation[i]);
            for (int j = 0; j < 3; ++j) x[i] += Rational(pose.rotation(i, j)) * Rational(v[j]);
        }
        result.emplace_back(x[0], x[1], x[2]);
    }
    return result;
}

Rational squared_distance_of(const Pair& pair) {
    const std::vector<Point> a = world_points(pair.a, pair.pose_a);
    const std::vector<Point> b = world_points(pair.b, pair.pose_b);
    CGAL::Polytope_distance_d<DistanceTraits> solver(a.begin(), a.end(), b.begin(), b.end());
    EXPECT_TRUE(solver.is_valid());
    return solver.squared_distance_numerator() / solver.squared_distance_denominator();
}

/// The least squared distance of the origin from a facet of A - B; 0 if A - B is flat and has none.
Rational squared_depth_of(const Pair& pair) {
    std::vector<Point> differences;
    for (const Point& p : world_points(pair.a, pair.pose_a)) {
        for (const Point& q : world_points(pair.b, pair.pose_b))
            differences.push_back(CGAL::ORIGIN + (p - q));
    }
    CGAL::Object hull;
    CGAL::convex_hull_3(differences.begin(), differences.end(), hull);
    const auto* solid = CGAL::object_cast<CGAL::Polyhedron_3<Kernel>>(&hull);
    if (!solid) return 0;
    std::optional<Rational> least;
    for (auto f = solid->facets_begin(); f != solid->facets_end(); ++f) {
        const auto h = f->halfedge();
        const Kernel::Plane_3 plane(h->vertex()->point(), h->next()->vertex()->point(),
                                    h->next()->next()->vertex()->point());
        const Rational square = CGAL::squared_distance(Point(CGAL::ORIGIN), plane);
        if (!least || square < *least) least = square;
    }
    return least.value_or(0);
}

/// Returns true if a double is the nearest to the root of a square. Compares the squares of the halfway
/// points.
bool is_nearest_root(double root, const Rational& square) {
    if (square == 0) return root == 0;
    const double infinity = std::numeric_limits<double>::infinity();
    const Rational below = (Rational(root) + Rational(std::nextafter(root, 0.0))) / 2;
    const Rational above = (Rational(root) + Rational(std::nextafter(root, infinity))) / 2;
    return root > 0 && below * below <= square && square <= above * above;
}

Pair random_pair(RandomBodies& random) {
    const auto count = [&] { return 4 + static_cast<int>(random.bits()() % 9); };
    Pair pair{random.on_sphere(count()), random.on_sphere(count()), {random.rotation(), random.unit()}, {}};
    const double thin = std::ldexp(1.0, -static_cast<int>(random.bits()() % 24));
    for (Vec3d& v : pair.b) v.z() *= thin;
    pair.pose_b = {random.rotation(), pair.pose_a.translation + 1.25 * (1 + random.number()) * random.unit()};
    const auto exact = exact_distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
    const double left = std::ldexp(random.number(), -static_cast<int>(random.bits()() % 45));
    if (random.number() < 0) pair.pose_b.translation += (1 - left) * exact->separation;
    return pair;
}

Pair lattice_pair(RandomBodies& random) {
    Vec3d shift = random.on_grid();
    const bool flat = random.bits()() % 4 == 0;
    if (flat) shift.z() = 0;
    const std::size_t count = 1 + random.bits()() % 8;
    Pair pair{random.on_grid(count), random.on_grid(1 + random.bits()() % 8), {}, moved(shift)};
    for (Points* points : {&pair.a, &pair.b}) {
        for (Vec3d& v : *points) v.z() *= flat ? 0 : 1;
    }
    return pair;
}

struct Tally {
    int verdicts[3] = {};

    void compare(const Pair& pair) {
        const auto exact = exact_distance(pair.a, pair.pose_a, pair.b, pair.pose_b);
        ASSERT_TRUE(exact) << exact.error;
        const Rational square = squared_distance_of(pair);
        EXPECT_TRUE(is_nearest_root(exact->distance, square)) << exact->distance;
        EXPECT_EQ(exact->verdict != ExactVerdict::separated, square == 0);
        ++verdicts[static_cast<int>(exact->verdict)];
        if (exact->verdict != ExactVerdict::separated) compare_depth(pair, exact->verdict);
    }

    void compare_depth(const Pair& pair, ExactVerdict verdict) {
        const auto exact = exact_depth(pair.a, pair.pose_a, pair.b, pair.pose_b);
        ASSERT_TRUE(exact) << exact.error;
        const Rational square = squared_depth_of(pair);
        EXPECT_TRUE(is_nearest_root(exact->depth, square)) << exact->depth;
        EXPECT_EQ(verdict == ExactVerdict::overlapping, square > 0);
    }

    void print(const char* name) const {
        std::printf("%s: %d separated, %d touching, %d overlapping\n", name, verdicts[0], verdicts[1],
                    verdicts[2]);
    }
};

TEST(CgalOpinion, agrees_on_random_and_grazing_pairs) {
    RandomBodies random(41);
    Tally tally;
    for (int i = 0; i < 300; ++i) tally.compare(random_pair(random));
    tally.print("random");
    EXPECT_GT(tally.verdicts[0], 100);
    EXPECT_GT(tally.verdicts[2], 50);
}

TEST(CgalOpinion, agrees_on_lattice_pairs) {
    RandomBodies random(42);
    Tally tally;
    for (int i = 0; i < 600; ++i) tally.compare(lattice_pair(random));
    tally.print("lattice");
    EXPECT_GT(tally.verdicts[0], 100);
    EXPECT_GT(tally.verdicts[1], 50);
    EXPECT_GT(tally.verdicts[2], 50);
}

TEST(CgalOpinion, agrees_far_off_and_on_skewed_poses) {
    RandomBodies random(43);
    Tally tally;
    for (int i = 0; i < 100; ++i) {
        Pair pair = random_pair(random);
        const Vec3d shift = std::ldexp(1.0, static_cast<int>(random.bits()() % 41)) * random.unit();
        pair.shift(shift);
        for (double& entry : pair.pose_a.rotation.reshaped()) entry += 1e-7 * random.number();
        tally.compare(pair);
    }
    tally.print("far off");
    EXPECT_GT(tally.verdicts[0], 30);
    EXPECT_GT(tally.verdicts[2], 10);
}

}  // namespace
}  // namespace edgewise::truth
