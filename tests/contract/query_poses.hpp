// SPDX-License-Identifier: MIT
//
// Relative poses for tests with many queries and without exact answers: far, near and overlapping; the
// algorithms that can use a table; and the comparison of two tables' answers to the bit.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise {

/// Poses of a body next to its copy, in any orientation, centres at most 2.5 extents from each other.
[[nodiscard]] inline std::vector<Transform<double>> query_poses(std::size_t count, const Polyhedron& body,
                                                                std::uint64_t seed) {
    scene::Rng rng(seed);
    const double size = extent(body.vertices);
    Vec3d middle = Vec3d::Zero();
    for (const Vec3d& v : body.vertices) middle += v / static_cast<double>(body.vertex_count());
    std::vector<Transform<double>> poses;
    while (poses.size() < count) {
        Transform<double> pose;
        pose.rotation = rng.rotation();
        // One random number per statement: compilers evaluate operands in either order.
        const double away = rng.uniform(0, 2.5) * size;
        const Vec3d place = middle + rng.on_sphere() * away;
        pose.translation = place - multiply(pose.rotation, middle);
        poses.push_back(pose);
    }
    return poses;
}

/// Calls use(algorithm) with every algorithm that can run on this table.
template <class Table, class Use>
void for_each_algorithm(Use use) {
    use(Gjk{});
    if constexpr (FeatureTable<Table>) use(VClip{});
}

inline void expect_same_bits(const Distance& a, const Distance& b) {
    EXPECT_EQ(a.status, b.status);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.cycles, b.cycles);
    EXPECT_EQ(a.fallbacks, b.fallbacks);
    EXPECT_EQ(std::memcmp(&a.distance, &b.distance, sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(a.point_a.data(), b.point_a.data(), 3 * sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(a.point_b.data(), b.point_b.data(), 3 * sizeof(double)), 0);
}

/// Answers of a cold and a warm query at each pose in turn.
template <class Algorithm, class T>
[[nodiscard]] std::vector<Distance> answers(const T& a, const T& b,
                                            const std::vector<Transform<double>>& poses) {
    using Pair = typename Algorithm::template Pair<T, T>;
    Pair warm(a, b);
    std::vector<Distance> result;
    for (const Transform<double>& pose : poses) {
        Pair cold(a, b);
        result.push_back(Algorithm::query(a, b, pose, cold));
        result.push_back(Algorithm::query(a, b, pose, warm));
    }
    return result;
}

}  // namespace edgewise
