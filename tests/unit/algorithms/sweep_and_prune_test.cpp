// SPDX-License-Identifier: MIT
//
// Sweep and prune against all pairs, over frames of coherent and of incoherent motion.
#include "edgewise/algorithms/sweep_and_prune.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/scene/rng.hpp"

namespace edgewise {
namespace {

std::vector<BodyPair> all_pairs(const std::vector<Aabb>& boxes) {
    std::vector<BodyPair> pairs;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
            const Aabb &a = boxes[i], &b = boxes[j];
            const bool apart =
                (a.high.array() < b.low.array()).any() || (b.high.array() < a.low.array()).any();
            if (!apart) pairs.push_back({i, j});
        }
    }
    return pairs;
}

std::vector<BodyPair> swept(SweepAndPrune& broad_phase, const std::vector<Aabb>& boxes) {
    const std::span<const BodyPair> pairs = broad_phase.update(boxes);
    return {pairs.begin(), pairs.end()};
}

/// Boxes on a coarse grid, so that equal ends and touching faces are common.
Aabb random_box(scene::Rng& rng, double world) {
    const auto grid = [](const Vec3d& p) { return Vec3d((p.array() * 4).round() / 4); };
    const Vec3d low = grid(rng.in_cube(world));
    const Vec3d size = grid((rng.in_cube(0.5).array() + 0.75).matrix());
    return {low, low + size};
}

TEST(SweepAndPrune, EqualsAllPairsOnFreshBoxes) {
    scene::Rng rng(11);
    std::size_t found = 0, possible = 0;
    for (const std::size_t count : {0U, 1U, 2U, 3U, 10U, 100U, 300U}) {
        SweepAndPrune broad_phase(count);
        for (int frame = 0; frame < 20; ++frame) {
            std::vector<Aabb> boxes(count);
            for (Aabb& box : boxes) box = random_box(rng, frame % 2 ? 3 : 8);
            const std::vector<BodyPair> want = all_pairs(boxes);
            ASSERT_EQ(swept(broad_phase, boxes), want) << count << " boxes, frame " << frame;
            found += want.size(), possible += count * (count - 1) / 2 * (count > 0);
        }
    }
    std::printf("fresh boxes: %zu of %zu pairs overlap\n", found, possible);
    EXPECT_GT(found, 5000U);
    EXPECT_LT(found, possible / 2);
}

TEST(SweepAndPrune, EqualsAllPairsInCoherentMotionWithFewMoves) {
    scene::Rng rng(12);
    constexpr std::size_t count = 200;
    std::vector<Aabb> boxes(count);
    std::vector<Vec3d> velocities(count);
    for (Aabb& box : boxes) box = random_box(rng, 4);
    for (Vec3d& velocity : velocities) velocity = rng.in_ball() * 0.05;
    SweepAndPrune broad_phase(count);
    std::size_t first_moves = 0, later_moves = 0, changes = 0;
    std::vector<BodyPair> last;
    for (int frame = 0; frame < 200; ++frame) {
        const std::vector<BodyPair> pairs = swept(broad_phase, boxes);
        ASSERT_EQ(pairs, all_pairs(boxes)) << "frame " << frame;
        changes += frame > 0 && pairs != last;
        (frame == 0 ? first_moves : later_moves) += broad_phase.moves();
        last = pairs;
        for (std::size_t i = 0; i < count; ++i) boxes[i].low += velocities[i], boxes[i].high += velocities[i];
    }
    std::printf(
        "coherent: %zu moves to sort at first, %.1f a frame later; pairs changed in %zu of 199 frames\n",
        first_moves, static_cast<double>(later_moves) / 199, changes);
    EXPECT_GT(changes, 100U);
    EXPECT_GT(later_moves, 0U);
    EXPECT_LT(later_moves / 199, first_moves / 10);
}

TEST(SweepAndPrune, EnlargingMovesAllSixSides) {
    const Aabb box = Aabb{{0, 1, 2}, {3, 4, 5}}.enlarged(0.5);
    EXPECT_EQ(box.low, Vec3d(-0.5, 0.5, 1.5));
    EXPECT_EQ(box.high, Vec3d(3.5, 4.5, 5.5));
}

}  // namespace
}  // namespace edgewise
