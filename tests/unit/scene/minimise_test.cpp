// SPDX-License-Identifier: MIT
//
// Synthetic failures with a known smallest case: the search finds it, and every step still fails.
#include "edgewise/scene/minimise.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "edgewise/scene/rng.hpp"

namespace edgewise::scene {
namespace {

Case random_pair(std::uint64_t seed, std::size_t vertices) {
    Rng rng(seed);
    Case pair{"random", {"a", {}, {}}, {"b", {}, {}}, {}, {}};
    for (CaseBody* body : {&pair.a, &pair.b})
        for (std::size_t i = 0; i < vertices; ++i)
            body->vertices.emplace_back(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1));
    pair.pose_a.translation = {rng.uniform(-1, 1), rng.uniform(-1, 1), 0.1};
    pair.pose_b.translation = {rng.uniform(-1, 1), 5.123456789, 0.3};
    return pair;
}

/// Fails as long as some vertex of A lies beyond 0.5 in x, and B has two vertices or more.
bool has_a_far_vertex(const Case& pair) {
    return pair.b.vertices.size() >= 2 &&
           std::ranges::any_of(pair.a.vertices, [](const Vec3d& v) { return v.x() > 0.5; });
}

TEST(Minimise, FindsTheSmallestCase) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Case pair = random_pair(seed, 40);
        ASSERT_TRUE(has_a_far_vertex(pair)) << seed;
        const Minimised found = minimise(pair, has_a_far_vertex);
        EXPECT_TRUE(has_a_far_vertex(found.pair));
        EXPECT_FALSE(found.at_limit);
        ASSERT_EQ(found.pair.a.vertices.size(), 1U);
        EXPECT_EQ(found.pair.b.vertices.size(), 2U);
        EXPECT_LE(size_of(found.pair).digits, 2U) << "two digits of an x above 0.5";
        EXPECT_TRUE(found.pair.pose_b.translation.isZero(0));
        EXPECT_EQ(minimise(pair, has_a_far_vertex).tried, found.tried) << "the same every time";
    }
}

/// Numbers that matter stay: here all digits of one of them.
TEST(Minimise, KeepsWhatTheFailureNeeds) {
    const Case pair = random_pair(3, 12);
    const double needed = pair.pose_b.translation.y();
    const auto fails = [&](const Case& candidate) {
        return candidate.pose_b.translation.y() - candidate.pose_a.translation.y() ==
               needed - pair.pose_a.translation.y();
    };
    const Minimised found = minimise(pair, fails);
    EXPECT_TRUE(fails(found.pair));
    EXPECT_LE(size_of(found.pair).vertices, 2U);
}

TEST(Minimise, DropsFacesBeforeVertices) {
    Case pair = random_pair(5, 4);
    pair.a.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
    const Minimised found = minimise(pair, [](const Case&) { return true; });
    EXPECT_FALSE(found.pair.a.faces);
    EXPECT_EQ(found.pair.a.vertices.size(), 1U);
    const Minimised kept =
        minimise(pair, [](const Case& candidate) { return candidate.a.faces.has_value(); });
    EXPECT_EQ(kept.pair.a.vertices.size(), 4U) << "faces name vertices";
}

TEST(Minimise, StopsAtItsLimit) {
    const Minimised found = minimise(random_pair(1, 40), has_a_far_vertex, 10);
    EXPECT_TRUE(found.at_limit);
    EXPECT_LE(found.tried, 10U);
    EXPECT_TRUE(has_a_far_vertex(found.pair));
}

}  // namespace
}  // namespace edgewise::scene
