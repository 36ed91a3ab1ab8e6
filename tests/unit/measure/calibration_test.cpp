// SPDX-License-Identifier: MIT
//
// Random pointer chases: the model gets exactly the loads that run, and its miss rate is the expected one.
#include "edgewise/measure/counters/calibration.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

namespace edgewise::measure {
namespace {

TEST(RandomChases, GoWhereTheReplayGoes) {
    RandomChase run(1 << 16), replayed(1 << 16);
    EXPECT_EQ(run.lines(), 1024U);
    std::vector<std::uint64_t> lines;
    run.run(5000);
    replayed.replay(5000, [](std::uint64_t) {});
    std::vector<std::uint64_t> after_run, after_replay;
    run.replay(5000, [&](std::uint64_t line) { after_run.push_back(line); });
    replayed.replay(5000, [&](std::uint64_t line) { after_replay.push_back(line); });
    EXPECT_EQ(after_run, after_replay);
    std::vector<int> met(1024, 0);
    for (const std::uint64_t line : after_run) ++met.at(line);
    for (const int times : met) EXPECT_LT(times, 30) << "nearly five each";
}

/// With N lines in a cache of C lines, a fraction (N - C) / N of random loads misses.
TEST(Calibration, ModelsWhatArithmeticSays) {
    CacheMachine machine;
    machine.name = "made up";
    machine.caches = {64, {{"L1D", 64, 8}, {"L2", 512, 16}}};
    machine.origins.resize(2);
    CalibrationOptions options;
    options.loads = 200'000;
    const auto rows = calibrate_model(machine, Cpu{}, options);
    ASSERT_EQ(rows.size(), 8U);
    for (const CalibrationRow& row : rows) {
        const double expected = row.times > 1 ? 1 - 1 / row.times : 0;
        std::printf("%s %.1f: modelled %.4f, %.2f ns\n", row.level.c_str(), row.times, row.modelled, row.ns);
        EXPECT_NEAR(row.modelled, expected, 0.01);
        EXPECT_GT(row.ns, 0);
        EXPECT_NE(row.counted.has_value(), !row.reason.empty()) << "counted, or said why not";
    }
}

}  // namespace
}  // namespace edgewise::measure
