// SPDX-License-Identifier: MIT
//
// Pieces of work under a limit, by a clock of the test's own: one is begun only where one as long as the
// longest so far still ends in time.
#include "edgewise/studies/advise/time_limit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "edgewise/scene/rng.hpp"

namespace edgewise::studies::advise {
namespace {

TEST(TimeLimit, LooksAtTheLongestPieceSoFar) {
    double now = 0;
    TimeLimit limit([&] { return now; }, 10);
    EXPECT_TRUE(limit.begin_piece());
    now = 3;
    EXPECT_TRUE(limit.begin_piece());
    now = 4;
    EXPECT_TRUE(limit.begin_piece()) << "until 7, if it is as long as the first";
    now = 6.9;
    EXPECT_TRUE(limit.begin_piece());
    EXPECT_NEAR(limit.left(), 3.1, 1e-12);
    now = 7;
    EXPECT_FALSE(limit.begin_piece()) << "until 10";
    now = 11;
    EXPECT_FALSE(limit.begin_piece());
    EXPECT_LT(limit.left(), 0);
}

/// Over the end goes only a piece longer than all before it, and never a second one.
TEST(TimeLimit, IsExceededByNoMoreThanAPieceThatNobodyCouldForesee) {
    scene::Rng rng(5);
    int kept = 0, exceeded = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        double now = 0, longest = 0, last = 0;
        const double end = rng.uniform(0.5, 20);
        TimeLimit limit([&] { return now; }, end);
        while (limit.begin_piece()) {
            ASSERT_LE(now, end);
            longest = std::max(longest, last);
            last = rng.uniform(0.1, 2);
            now += last;
        }
        ++(now <= end ? kept : exceeded);
        if (now > end) {
            EXPECT_GT(last, longest);
        }
    }
    EXPECT_GT(kept, 100);
    EXPECT_GT(exceeded, 100);
}

}  // namespace
}  // namespace edgewise::studies::advise
