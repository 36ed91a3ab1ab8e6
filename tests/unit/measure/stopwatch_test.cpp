// SPDX-License-Identifier: MIT
//
// The stopwatch. No test asserts how long an operation takes. Tests compare the stopwatch with another clock,
// and check the order and sign of its readings. What others take of the processor is the time that a thread
// does not run.
#include "edgewise/measure/stopwatch.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <thread>

#include "edgewise/measure/machine/quietness.hpp"

namespace edgewise::measure {
namespace {

TEST(Stopwatch, NeverRunsBackwards) {
    const Stopwatch watch;
    double before = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double now = watch.elapsed_ns();
        ASSERT_GE(now, before);
        before = now;
    }
    EXPECT_GT(before, 0);
}

TEST(Stopwatch, CountsNanoseconds) {
    // Enclosed by two readings of the clock inside and outside of it, whatever the machine was busy with.
    const auto outside = Stopwatch::Clock::now();
    const Stopwatch watch;
    const auto inside = Stopwatch::Clock::now();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const auto inside_end = Stopwatch::Clock::now();
    const double elapsed = watch.elapsed_ns();
    const auto outside_end = Stopwatch::Clock::now();
    using Nanoseconds = std::chrono::duration<double, std::nano>;
    EXPECT_GE(elapsed, Nanoseconds(inside_end - inside).count());
    EXPECT_LE(elapsed, Nanoseconds(outside_end - outside).count());
    EXPECT_GE(elapsed, 2e6);  // sleep_for sleeps at least that long, by the same clock
}

TEST(Stopwatch, RestartForgets) {
    Stopwatch watch;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const double long_before = watch.elapsed_ns();
    const Stopwatch reference;  // started before the restart, so it can only show more
    watch.restart();
    const double after = watch.elapsed_ns();
    EXPECT_LE(after, reference.elapsed_ns());
    EXPECT_GE(long_before, 2e6);
}

TEST(Stopwatch, CalibrationIsAReadingAndNotNegative) {
    for (const std::size_t readings :
         {std::size_t{0}, std::size_t{1}, std::size_t{10}, std::size_t{10'001}}) {
        const Stopwatch all;
        const double cost = calibrate(readings);
        EXPECT_GE(cost, 0);
        EXPECT_LE(cost, all.elapsed_ns());  // the cost of one pair of readings, not of them all
    }
    std::printf("an empty start and stop: %g ns\n", calibrate());
}

TEST(ShareOfOthers, IsThePartOfTheTimeInWhichTheThreadDoesNotRun) {
    ShareOfOthers others;
    EXPECT_EQ(others.share(), 0);
    others.begin();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    others.end();
    EXPECT_GT(others.share(), 0.5) << "a thread that sleeps takes microseconds of 50 ms";
}

TEST(Quietness, IsOfThisMachine) {
    const Quietness now = look_at_quietness();
    EXPECT_GE(now.others, 0);
    EXPECT_LE(now.others, 1);
    EXPECT_GE(now.scatter, 0);
    EXPECT_FALSE((Quietness{.others = 0.5, .scatter = 0}.is_quiet()));
    EXPECT_FALSE((Quietness{.others = 0, .scatter = 0.3}.is_quiet()));
    EXPECT_TRUE((Quietness{.others = 0.001, .scatter = 0.01}.is_quiet()));
    std::printf("others take %g, fixed work varies by %g\n", now.others, now.scatter);
}

}  // namespace
}  // namespace edgewise::measure
