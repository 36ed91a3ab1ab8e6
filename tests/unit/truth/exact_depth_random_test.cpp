// SPDX-License-Identifier: MIT
//
// Exact penetration depth on random pairs: against every separating axis in double, against exact_distance
// after moving the bodies by the depth, and against itself under swap, permutation, seeds and scaling.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "brute_depth.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "edgewise/truth/exact_proof.hpp"
#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

/// Two bodies of 4 to `largest` vertices, some flattened, that overlap.
struct DeepPair : PosedPoints {
    DeepPair(RandomBodies& random, int largest) {
        const auto count = [&] { return 4 + static_cast<int>(random.bits()() % (largest - 3)); };
        do {
            a = random.on_sphere(count());
            b = random.on_sphere(count());
            const double thin = std::ldexp(1.0, -static_cast<int>(random.bits()() % 24));
            for (Vec3d& v : b) v.z() *= thin;
            pose_a = {random.rotation(), random.unit()};
            pose_b = {random.rotation(), pose_a.translation + 0.75 * (1 + random.number()) * random.unit()};
        } while (exact_distance(a, pose_a, b, pose_b)->verdict != ExactVerdict::overlapping);
    }

    [[nodiscard]] ExactDepth ask() const { return *exact_depth(a, pose_a, b, pose_b); }
};

TEST(ExactDepthRandom, agrees_with_every_separating_axis) {
    RandomBodies random(22);
    double worst = 0;
    int compared = 0, shallow = 0;
    for (int i = 0; i < 600; ++i) {
        const DeepPair pair(random, 14);
        const Result<Polyhedron> a = convex_hull(pair.a);
        const Result<Polyhedron> b = convex_hull(pair.b);
        if (!a || !b) continue;
        const double expected = testing::brute_depth(*a, *b, relative_pose(pair.pose_a, pair.pose_b)).depth;
        const double depth = pair.ask().depth;
        worst = std::max(worst, std::abs(depth - expected));
        ++compared;
        shallow += depth < 0.1;
    }
    std::printf("axes: worst difference %.3g over %d pairs, %d of them shallow\n", worst, compared, shallow);
    EXPECT_LT(worst, 1e-12);
    EXPECT_GT(compared, 400);
    EXPECT_GT(shallow, 30);
}

/// Moved by a little more than the depth the bodies part; along no direction does less do.
TEST(ExactDepthRandom, is_the_least_motion_that_parts) {
    RandomBodies random(23);
    int large = 0;
    for (int i = 0; i < 150; ++i) {
        const DeepPair pair(random, i % 10 == 0 ? 386 : 40);
        const ExactDepth deep = pair.ask();
        ASSERT_GT(deep.depth, 0);
        EXPECT_NEAR(norm(deep.normal), 1, 4e-16);
        const auto after = [&](const Vec3d& by) {
            Pose pose_b = pair.pose_b;
            pose_b.translation += by;
            return exact_distance(pair.a, pair.pose_a, pair.b, pose_b)->verdict;
        };
        // A rounded normal and translation may miss by some 1e-16 of the size, which is 1.
        EXPECT_EQ(after((deep.depth + 4e-15) * deep.normal), ExactVerdict::separated) << i;
        EXPECT_EQ(after((deep.depth - 4e-15) * deep.normal), ExactVerdict::overlapping) << i;
        for (int k = 0; k < 20; ++k) {
            const Vec3d less = (1 - 1e-9) * deep.depth * random.unit();
            EXPECT_EQ(after(less), ExactVerdict::overlapping) << i;
        }
        large += pair.a.size() + pair.b.size() > 300;
    }
    EXPECT_GT(large, 5);
}

TEST(ExactDepthRandom, same_bits_under_swap_permutation_seed_and_scale) {
    RandomBodies random(24);
    for (int i = 0; i < 150; ++i) {
        DeepPair pair(random, 30);
        const ExactDepth deep = pair.ask();
        const ExactDepth swapped = *exact_depth(pair.b, pair.pose_b, pair.a, pair.pose_a);
        EXPECT_EQ(swapped.depth, deep.depth);
        EXPECT_EQ(swapped.normal, Vec3d(-deep.normal));
        const SimplexSeed seed = exact_distance(pair.a, pair.pose_a, pair.b, pair.pose_b)->simplex;
        EXPECT_EQ(exact_depth(pair.a, pair.pose_a, pair.b, pair.pose_b, seed)->depth, deep.depth);
        std::shuffle(pair.a.begin(), pair.a.end(), random.bits());
        pair.b.push_back(pair.b.front());
        const double factor = std::ldexp(1.0, i % 2 == 0 ? 800 : -800);
        pair.scale(factor);
        const ExactDepth scaled = pair.ask();
        EXPECT_EQ(scaled.depth, deep.depth * factor);
        EXPECT_EQ(scaled.normal, deep.normal);
    }
}

}  // namespace
}  // namespace edgewise::truth
