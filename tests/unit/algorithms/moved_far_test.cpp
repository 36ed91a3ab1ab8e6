// SPDX-License-Identifier: MIT
//
// GJK after much motion and after little: pairs with an old simplex that lies far off start as cold ones do,
// to the bit; others start from it, and give the same distance.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/lean_seeds.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise {
namespace {

struct MovedPairs {
    int asked = 0, as_cold = 0;  ///< pairs with a cold query of some steps
    double worst = 0;            ///< difference from a cold query's distance
};

/// A body and its copy in pose after pose from which they are separated, each asked warm and cold.
template <class Table, class NextRotation>
MovedPairs ask_moving(const char* shape, scene::Rng& rng, NextRotation next) {
    const Table table(*scene::make_shape(shape), Parts::support);
    MovedPairs moved;
    for (int i = 0; i < 30; ++i) {
        SimplexPair<Table, Table> warm(table, table);
        Transform<double> pose{rng.rotation(), rng.on_sphere() * rng.uniform(3.6, 5) * table.reach()};
        (void)Gjk::query(table, table, pose, warm);
        for (int step = 0; step < 20; ++step) {
            pose.rotation = next(pose.rotation);
            SimplexPair<Table, Table> cold(table, table);
            const Distance fresh = Gjk::query(table, table, pose, cold);
            const Distance answer = Gjk::query(table, table, pose, warm);
            EXPECT_EQ(answer.status, Status::separated);
            const bool same = warm == cold && answer.steps == fresh.steps &&
                              answer.distance == fresh.distance && answer.point_a == fresh.point_a;
            moved.asked += fresh.steps > 2;
            moved.as_cold += same && fresh.steps > 2;
            moved.worst = std::max(moved.worst, std::abs(answer.distance - fresh.distance));
        }
    }
    std::printf("%s: %d of %d as cold, worst difference %.3g\n", shape, moved.as_cold, moved.asked,
                moved.worst);
    return moved;
}

template <class Table>
void expect_fresh_starts(double most_difference) {
    scene::Rng rng(11);
    for (const char* shape : {"cube8", "sphere38", "sphere386"}) {
        const MovedPairs moved = ask_moving<Table>(shape, rng, [&](const Mat3d&) { return rng.rotation(); });
        EXPECT_GT(moved.as_cold, moved.asked / 2);
        EXPECT_LT(moved.worst, most_difference);
    }
}

TEST(MovedFar, PairsInAnyPoseStartAsColdOnesDo) { expect_fresh_starts<aos<f64>>(1e-14); }

TEST(MovedFar, InSingleFromSeedsToo) { expect_fresh_starts<lean_seeds<f32>>(1e-5); }

TEST(MovedFar, PairsThatHardlyMovedStartFromWhereTheyEnded) {
    scene::Rng rng(12);
    for (const char* shape : {"cube8", "sphere38", "sphere386"}) {
        const MovedPairs moved = ask_moving<aos<f64>>(shape, rng, [&](const Mat3d& rotation) {
            return Mat3d(Eigen::AngleAxisd(0.01, rng.on_sphere()).toRotationMatrix() * rotation);
        });
        EXPECT_LT(moved.as_cold, moved.asked / 10);
        EXPECT_LT(moved.worst, 1e-14);
    }
}

/// Bodies with origins far outside of them start from their old simplex.
TEST(MovedFar, BodiesFarFromTheirOriginsAreNotTakenForMoved) {
    std::vector<Vec3d> corners = scene::make_shape("sphere386")->vertices;
    for (Vec3d& corner : corners) corner += Vec3d(1000, 0, 0);
    const aos<f64> table(*convex_hull(corners), Parts::support);
    SimplexPair<aos<f64>, aos<f64>> pair(table, table);
    for (int step = 0; step < 20; ++step) {
        const Transform<double> pose{Mat3d::Identity(), {0, 3 + 0.05 * step, 0}};
        const Distance answer = Gjk::query(table, table, pose, pair);
        EXPECT_EQ(answer.status, Status::separated);
        EXPECT_TRUE(step == 0 || answer.steps <= 2) << answer.steps;
    }
}

}  // namespace
}  // namespace edgewise
