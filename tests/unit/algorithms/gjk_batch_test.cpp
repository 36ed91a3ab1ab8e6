// SPDX-License-Identifier: MIT
#include "edgewise/algorithms/query_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <type_traits>
#include <vector>

#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/points_soa.hpp"
#include "edgewise/scene/shapes.hpp"
#include "pair_crowd.hpp"

namespace edgewise {
namespace {

template <class Table>
class GjkBatches : public testing::Test {};
using Tables =
    testing::Types<points_soa<f64>, points_soa<f32>, points_soa<mixed>, lean<f64>, lean<f32>, aos<f64>>;
TYPED_TEST_SUITE(GjkBatches, Tables);

/// One frame after the other, from cold on, with both ways side by side.
template <class Table>
void expect_same_frames(const QueryOptions& options) {
    if (!has_lanes()) GTEST_SKIP() << "this processor has no lanes";
    constexpr std::size_t count = 4000;
    PairCrowd<Table> crowd(count);
    std::size_t in_lanes = 0, singly = 0, different = 0;
    for (const double step : {0.0, 0.001, 0.01, 0.1, 1.0}) {
        crowd.move(step);
        const std::vector<Distance> expected = crowd.one_by_one(options);
        std::vector<Distance> answers(count);
        GjkBatch<Table, Table> batch(crowd.queries, answers, options);
        batch.run();
        for (std::size_t i = 0; i < count; ++i)
            different += !same_bits(expected[i], answers[i]) || crowd.single_pairs[i] != crowd.batch_pairs[i];
        singly += batch.asked_singly();
        in_lanes += count - batch.asked_singly();
    }
    EXPECT_EQ(different, 0U);
    EXPECT_GT(in_lanes, 1000U);
    EXPECT_GT(singly, 1000U) << "of overlapping pairs, and of large bodies";
    std::printf("%zu answers by lanes, %zu singly, %zu differ\n", in_lanes, singly, different);
}

TYPED_TEST(GjkBatches, AreToTheBitSingleQueries) { expect_same_frames<TypeParam>({}); }

TYPED_TEST(GjkBatches, HonourTheOptions) {
    expect_same_frames<TypeParam>({.contact_tolerance = 0.3});
    expect_same_frames<TypeParam>({.gap_tolerance = 1e-2});
}

/// Which no lane knows: one query after the other.
TYPED_TEST(GjkBatches, AskOneByOneForJohnsonsSearchAndWithACutoff) {
    constexpr std::size_t count = 1000;
    for (const QueryOptions& options :
         {QueryOptions{.sub_distance = SubDistanceSolver::johnson}, QueryOptions{.cutoff = 0}}) {
        PairCrowd<TypeParam> crowd(count);
        for (const double step : {0.0, 0.01, 1.0}) {
            crowd.move(step);
            const std::vector<Distance> expected = crowd.one_by_one(options);
            std::vector<Distance> answers(count);
            query_batch<TypeParam, TypeParam>(crowd.queries, answers, options);
            for (std::size_t i = 0; i < count; ++i) {
                EXPECT_TRUE(same_bits(expected[i], answers[i])) << i;
                EXPECT_TRUE(crowd.single_pairs[i] == crowd.batch_pairs[i]) << i;
            }
        }
    }
}

/// Tables were rebuilt since the last query: their pairs start cold.
TEST(GjkBatch, FollowsNoHandleOfARebuiltTable) {
    using Table = points_soa<f64>;
    PairCrowd<Table> crowd(500);
    static_cast<void>(crowd.one_by_one({}));
    crowd.batch_pairs = crowd.single_pairs;
    for (Table& table : crowd.tables) table = Table(scene::make_shape("tetra4").or_throw(), Parts::support);
    const std::vector<Distance> expected = crowd.one_by_one({});
    std::vector<Distance> answers(crowd.queries.size());
    query_batch<Table, Table>(crowd.queries, answers);
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_TRUE(same_bits(expected[i], answers[i])) << i;
}

}  // namespace
}  // namespace edgewise
