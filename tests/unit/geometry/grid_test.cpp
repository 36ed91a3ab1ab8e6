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
            const Grid grid(points, eps);
            std::vector<Vec3d> moved;
            for (const Vec3d& p : points) {
                moved.push_back(grid.at(grid.nearest(p)));
                worst = std::max(worst, max_abs(Vec3d(moved.back() - p)) / grid.step);
                if (eps > 1e-10) {
                    EXPECT_EQ(moved.back(), to_single(moved.back()));
                }
            }
            const Grid again(moved, eps);
            for (const Vec3d& p : moved) EXPECT_EQ(again.at(again.nearest(p)), p);
        }
    }
    std::printf("moved by %.3f steps at most\n", worst);
    EXPECT_LE(worst, 0.5);
    EXPECT_GT(worst, 0.4);
}

}  // namespace
}  // namespace edgewise
