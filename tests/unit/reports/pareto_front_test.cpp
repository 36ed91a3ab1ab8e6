// SPDX-License-Identifier: MIT
//
// The front of times and errors against its definition, asked of every pair of points, on random clouds of
// few values (many ties) and of many (none).
#include "edgewise/reports/tables/tables.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace edgewise::reports {
namespace {

using Cloud = std::vector<SpeedError>;

Cloud random_cloud(std::mt19937& random, int values) {
    std::uniform_int_distribution<int> size(0, 30), value(0, values - 1);
    Cloud cloud;
    for (int left = size(random); left > 0; --left)
        cloud.push_back({static_cast<double>(value(random)), static_cast<double>(value(random))});
    return cloud;
}

TEST(ParetoFront, IsWhatNothingDominatesAndDominatesTheRest) {
    std::mt19937 random(1);
    std::size_t on = 0, off = 0, twins = 0;
    for (int round = 0; round < 3000; ++round) {
        const Cloud cloud = random_cloud(random, round % 2 ? 6 : 1000000);
        const std::vector<bool> front = pareto_front(cloud);
        ASSERT_EQ(front.size(), cloud.size());
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            bool by_any = false, by_front = false;
            for (std::size_t j = 0; j < cloud.size(); ++j) {
                // Written out: the oracle shares nothing with what it judges.
                const bool no_worse = cloud[j].ns <= cloud[i].ns && cloud[j].error <= cloud[i].error;
                const bool equal = cloud[j].ns == cloud[i].ns && cloud[j].error == cloud[i].error;
                by_any |= no_worse && !equal;
                by_front |= no_worse && !equal && front[j];
                twins += equal && i != j && front[i] && front[j];
            }
            EXPECT_EQ(front[i], !by_any);
            EXPECT_EQ(by_any, by_front) << "what is dominated is dominated by one of the front";
            (front[i] ? on : off) += 1;
        }
    }
    EXPECT_GT(on, 1000U);
    EXPECT_GT(off, 1000U);
    EXPECT_GT(twins, 100U) << "equal points of a front";
}

TEST(ParetoFront, KeepsEqualPointsAndKnowsInfinityButNoNaN) {
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(pareto_front(Cloud{{2, 1}, {1, 2}, {2, 1}, {2, 2}, {1, infinite}}),
              (std::vector<bool>{true, true, true, false, false}));
    EXPECT_EQ(pareto_front(Cloud{{1, infinite}, {2, 0}}), (std::vector<bool>{true, true}));
    EXPECT_EQ(pareto_front(Cloud{{std::nan(""), 0}, {0, std::nan("")}, {3, 3}}),
              (std::vector<bool>{false, false, true}));
    EXPECT_TRUE(pareto_front({}).empty());
}

}  // namespace
}  // namespace edgewise::reports
