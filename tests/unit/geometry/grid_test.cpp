// SPDX-License-Identifier: MIT
//
// The grid of `quantised`: what rounding to it moves.
#include "edgewise/geometry/grid.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/geometry/single.hpp"
#include "edgewise/scene/rng.hpp"

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

}  // namespace
}  // namespace edgewise
