// SPDX-License-Identifier: MIT
//
// The cycle guard on made-up runs: a tail, then a loop, of every length; it must end each, and never call out
// before a pair has really come back.
#include "edgewise/algorithms/vclip/cycle_guard.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace edgewise {
namespace {

using Guard = vclip::CycleGuard<int, int>;

/// State k of a run with `tail` states before a loop of `loop` states.
int state_at(int k, int tail, int loop) { return k < tail ? k : tail + (k - tail) % loop; }

TEST(CycleGuard, EndsEveryLoopAndOnlyLoops) {
    double slowest = 0;
    for (int tail = 0; tail < 200; ++tail) {
        for (int loop = 1; loop < 200; ++loop) {
            Guard guard(state_at(0, tail, loop), 0);
            const int allowed = 20 + 8 * (tail + loop);
            int k = 1;
            while (k < allowed && !guard.returns_to(state_at(k, tail, loop), 0)) ++k;
            ASSERT_LT(k, allowed) << "a tail of " << tail << " and a loop of " << loop << " never ended";
            ASSERT_GE(k, tail + loop) << "called before state " << state_at(k, tail, loop) << " came back";
            slowest = std::max(slowest, static_cast<double>(k) / (tail + loop));
        }
    }
    std::printf("cycle guard: at worst %.1f times the states there are\n", slowest);
}

TEST(CycleGuard, NeverCallsOutWhereNothingComesBack) {
    Guard guard(0, 0);
    for (int k = 1; k < 1000000; ++k) ASSERT_FALSE(guard.returns_to(k, k % 7)) << k;
}

TEST(CycleGuard, BothFeaturesCount) {
    Guard guard(1, 1);
    EXPECT_FALSE(guard.returns_to(1, 2));
    EXPECT_FALSE(guard.returns_to(2, 1));
    EXPECT_TRUE(guard.returns_to(1, 1));
}

}  // namespace
}  // namespace edgewise
