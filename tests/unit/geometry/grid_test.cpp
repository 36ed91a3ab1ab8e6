// SPDX-License-Identifier: MIT
//
// The grid of `quantised`: what rounding to it moves; and rounding outward, where the result contains the
// body, by exact arithmetic.
#include "edgewise/geometry/grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise {
namespace {

TEST(Grid, MovesACoordinateByHalfAStepAtMostAndThenNoMore) {
    scene::Rng rng(2);
    double worst = 0;
    for (int i = 0; i < 100; ++i) {
        const Vec3d far = 100 * rng.in_cube(1), size = Vec3d(1, 0.3, 0.01);
        std::vector<Vec3d> points;
        for (int k = 0; k < 40; ++k) points.push_back(far + rng.in_cube(1).cwiseProduct(size));
        for (const double eps : {0x1p-52, 0x1p-23}) {
            const Grid grid = Grid::for_rounding(points, eps);
            std::vector<Vec3d> moved;
            for (const Vec3d& p : points) {
                moved.push_back(grid.at(grid.nearest(p)));
                worst = std::max(worst, max_abs(Vec3d(moved.back() - p)) / grid.step);
                if (eps > 1e-10) {
                    EXPECT_EQ(moved.back(), to_single(moved.back()));
                }
            }
            const Grid again = Grid::of_rounded(moved, eps);
            for (const Vec3d& p : moved) EXPECT_EQ(again.at(again.nearest(p)), p);
        }
    }
    std::printf("moved by %.3f steps at most\n", worst);
    EXPECT_LE(worst, 0.5);
    EXPECT_GT(worst, 0.4);
}

/// Sides a little below a power of two: rounding makes the box a step longer, which must not make the grid
/// that is made of the rounded points twice as wide.
TEST(Grid, HoldsWhatWasRoundedToIt) {
    scene::Rng rng(3);
    int longer = 0;
    for (int i = 0; i < 2000; ++i) {
        const double side = 1 - 0x1p-16 * rng.uniform(0, 4);
        std::vector<Vec3d> points = {Vec3d(0, 0, 0), Vec3d(side, 0, 0)};
        for (int k = 0; k < 6; ++k) points.push_back(rng.in_cube(0.4) + Vec3d(0.45, 0, 0));
        const Vec3d off = rng.in_cube(1);
        for (Vec3d& p : points) p += off;
        for (const double eps : {0x1p-52, 0x1p-23}) {
            const Grid grid = Grid::for_rounding(points, eps);
            std::vector<Vec3d> moved;
            for (const Vec3d& p : points) moved.push_back(grid.at(grid.nearest(p)));
            const Grid again = Grid::of_rounded(moved, eps);
            EXPECT_LE(again.step, grid.step);
            for (const Vec3d& p : moved) EXPECT_EQ(again.at(again.nearest(p)), p);
            longer += moved[1].x() - moved[0].x() > side;
        }
    }
    std::printf("%d of 4000 boxes became longer\n", longer);
    EXPECT_GT(longer, 400);
}

/// Every vertex of the body lies in the hull of the other's vertices, by exact arithmetic.
bool exactly_contains(const Polyhedron& outer, const Polyhedron& body) {
    return std::all_of(body.vertices.begin(), body.vertices.end(), [&](const Vec3d& v) {
        const auto exact = truth::exact_distance(std::vector{v}, {}, outer.vertices, {});
        return exact && exact->verdict != truth::ExactVerdict::separated;
    });
}

Polyhedron random_hull(scene::Rng& rng, const Vec3d& middle, const Vec3d& size) {
    std::vector<Vec3d> points;
    for (int k = 0; k < 30; ++k) points.push_back(middle + rng.in_ball().cwiseProduct(size));
    return *convex_hull(points);
}

TEST(Grid, OfSinglesHasTheirRange) {
    for (const double size : {1e39, 1e20}) {
        const Polyhedron body = scene::scaled(scene::make_shape("cube8").or_throw(), size);
        for (const auto round : {round_to_grid, round_to_grid_outward}) {
            EXPECT_FALSE(round(body, 0x1p-23)) << size;
            EXPECT_TRUE(round(body, 0x1p-52)) << size;
        }
    }
}

TEST(GridOutward, ContainsTheBody) {
    scene::Rng rng(4);
    int grown = 0, not_contained = 0;
    for (int i = 0; i < 120; ++i) {
        const Vec3d far = i % 2 == 0 ? Vec3d(1000 * rng.in_cube(1)) : Vec3d::Zero();
        const Polyhedron body = random_hull(rng, far, {1, 0.5, 0.2});
        for (const double eps : {0x1p-52, 0x1p-23}) {
            const auto nearest = round_to_grid(body, eps), outward = round_to_grid_outward(body, eps);
            ASSERT_TRUE(nearest && outward) << nearest.error << outward.error;
            EXPECT_TRUE(exactly_contains(*outward, body)) << i << ": " << eps;
            if (eps < 1e-10) {
                EXPECT_LT(volume(*outward), volume(body) * 1.001);
            }
            not_contained += !exactly_contains(*nearest, body);
            grown += volume(*outward) > volume(*nearest);
        }
    }
    EXPECT_GT(not_contained, 200);
    EXPECT_GE(grown, not_contained);
}

/// Too thin to be widened by growing, a body becomes the hull of boxes, with more vertices.
TEST(GridOutward, ContainsThinBodies) {
    scene::Rng rng(5);
    int boxed = 0;
    for (int i = 0; i < 120; ++i) {
        const double thickness = std::ldexp(1.0, -(i % 12 + 3));
        const Polyhedron body = random_hull(rng, Vec3d::Zero(), {1, 0.5, thickness});
        const auto outward = round_to_grid_outward(body, 0x1p-52);
        ASSERT_TRUE(outward) << i << ": " << outward.error;
        EXPECT_TRUE(exactly_contains(*outward, body)) << i;
        boxed += outward->vertex_count() > body.vertex_count();
    }
    EXPECT_GT(boxed, 20);
}

TEST(GridOutward, ABodyThatWasRoundedStaysAsItIs) {
    scene::Rng rng(6);
    for (int i = 0; i < 40; ++i) {
        const auto once = round_to_grid_outward(random_hull(rng, rng.in_cube(3), {1, 0.5, 0.2}), 0x1p-52);
        ASSERT_TRUE(once) << once.error;
        EXPECT_EQ(round_to_grid_outward(*once, 0x1p-52)->vertices, once->vertices) << i;
    }
}

}  // namespace
}  // namespace edgewise
