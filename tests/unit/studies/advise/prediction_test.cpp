// SPDX-License-Identifier: MIT
//
// A prediction from made-up misses. Sums were done by hand.
#include "edgewise/studies/advise/prediction.hpp"

#include <gtest/gtest.h>

namespace edgewise::studies::advise {
namespace {

TEST(Prediction, WaitsForEachLevel) {
    CacheCost cost;
    cost.in_cache_ns = 100;
    cost.misses = {{this_machine, {10, 4}}, {"one_level", {10}}, {"three_levels", {10, 4, 1}}};
    predict(cost, std::vector<double>{5, 80});  // the second level, memory
    EXPECT_DOUBLE_EQ(cost.predicted_ns.at(this_machine), 100 + 6 * 5 + 4 * 80);
    EXPECT_DOUBLE_EQ(cost.predicted_ns.at("one_level"), 100 + 10 * 80);
    EXPECT_DOUBLE_EQ(cost.predicted_ns.at("three_levels"), 100 + 6 * 5 + 3 * 80 + 1 * 80);
}

TEST(Prediction, IsNoneWithoutLatenciesOrTheTimeInCache) {
    CacheCost cost;
    cost.misses = {{this_machine, {10, 4}}};
    predict(cost, std::vector<double>{5, 80});
    cost.in_cache_ns = 100;
    predict(cost, {});
    EXPECT_TRUE(cost.predicted_ns.empty());
}

}  // namespace
}  // namespace edgewise::studies::advise
