// SPDX-License-Identifier: MIT
//
// V-Clip on boxes with closest edges that lie along each other to 1e-15 to 1e-3 rad, from a hundredth of
// their length to four lengths from each other: which ends are nearer is up to the last digits of a slope,
// and where the wrong ones are taken, the distance is off by the angle. Beside exact arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "reference_table.hpp"

namespace edgewise {
namespace {

/// Places B's edge along z diagonally next to A's, and turns it a little about any axis.
Pose nearly_parallel(scene::Rng& rng, double half_a, double half_b) {
    const double gap = std::pow(10.0, rng.uniform(-2.9, 0.6)), aside = rng.uniform(0.1, 1.4);
    const double angle = std::pow(10.0, rng.uniform(-15, -3));
    Pose pose;
    pose.rotation = rotation_matrix(scene::rotation_about(rng.on_sphere(), angle));
    pose.translation = {half_a + half_b + gap * std::cos(aside), half_a + half_b + gap * std::sin(aside),
                        rng.uniform(-half_a, half_a)};
    return pose;
}

struct ParallelErrors {
    double worst = 0;
    int queries = 0, asked_gjk = 0;
};

template <class Table>
ParallelErrors errors_beside_parallels(const Polyhedron& body, const Table& table) {
    const double half = max_abs(body.vertices[0]);
    scene::Rng rng(5);
    ParallelErrors sums;
    for (int i = 0; i < 4000; ++i) {
        const Pose pose = nearly_parallel(rng, half, half);
        FeaturePair<Table, Table> pair(table, table);
        const Distance answer = VClip::query(table, table, {pose.rotation, pose.translation}, pair);
        const auto exact = truth::exact_distance(body.vertices, Pose{}, body.vertices, pose).or_throw();
        EXPECT_EQ(answer.status, Status::separated);
        sums.worst = std::max(sums.worst, std::abs(answer.distance - exact.distance));
        sums.asked_gjk += answer.fallbacks + answer.refinements;
        ++sums.queries;
    }
    return sums;
}

TEST(NearlyParallelEdges, AreAsFarFromEachOtherAsExactArithmeticSays) {
    const Polyhedron body = *scene::make_shape("cube8");
    for (const ParallelErrors& sums : {errors_beside_parallels(body, ReferenceTable(body)),
                                       errors_beside_parallels(body, lean<f64>(body, Parts::features))}) {
        std::printf("worst error %.3g of %d, %d asked GJK\n", sums.worst, sums.queries, sums.asked_gjk);
        EXPECT_LT(sums.worst, 1e-14);
        EXPECT_LT(sums.asked_gjk, sums.queries / 4) << "V-Clip is what is tested";
    }
}

/// Boxes face to face, a few rounding steps of the precision apart.
template <class Table>
int farthest_contact(double step, int& separated) {
    const Table table(*scene::make_shape("cube8"), Parts::features);
    const double side = 2 * max_abs(cast<double>(table.vertex(table.first_vertex())));
    int farthest = 0;
    for (int steps = 0; steps <= 64; ++steps) {
        const Vec3d apart(side + steps * step * side, 0, 0);
        FeaturePair<Table, Table> pair(table, table);
        const Distance answer = VClip::query(table, table, {Mat3d::Identity(), apart}, pair);
        if (answer.status == Status::touching) farthest = steps;
        if (answer.status != Status::separated) continue;
        ++separated;
        EXPECT_NEAR(answer.distance, steps * step * side, 2 * step * side) << steps;
    }
    return farthest;
}

/// A contact tolerance as wide as the band (16 steps) would leave no room for rounding.
TEST(VClipNearContact, IsContactWithinHalfTheBand) {
    int separated = 0, separated_in_single = 0;
    const int farthest = farthest_contact<aos<f64>>(0x1p-51, separated),
              in_single = farthest_contact<aos<f32>>(0x1p-22, separated_in_single);
    std::printf("contact up to %d steps in double, %d in single\n", farthest, in_single);
    EXPECT_LE(farthest, 8);
    EXPECT_LE(in_single, 1);
    EXPECT_GT(std::min(separated, separated_in_single), 50);
}

}  // namespace
}  // namespace edgewise
