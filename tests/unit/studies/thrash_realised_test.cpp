// SPDX-License-Identifier: MIT
//
// Cells made real: which are chosen, and that a pass under the pager has the faults of the trace and the
// answers of a pass without it.
#include "edgewise/studies/thrash/realised_cell.hpp"

#include <gmock/gmock.h>

#include "edgewise/studies/thrash/thrash_rows.hpp"

namespace edgewise::studies::thrash {
namespace {

Outcome outcome_of(double fault_ns, std::size_t bodies, int facts, double rise) {
    Outcome outcome;
    outcome.setting.bodies = bodies;
    outcome.setting.fault_ns = fault_ns;
    outcome.score.rise = rise;
    for (int i = 0; i < facts; ++i) outcome.score.holds[static_cast<std::size_t>(i)] = true;
    return outcome;
}

TEST(ThrashRealised, TakesTheBestSettingOfEachCost) {
    Factorial factorial;
    factorial.outcomes = {outcome_of(1e4, 1, 1, 12), outcome_of(1e5, 2, 3, 20), outcome_of(1e5, 3, 3, 11),
                          outcome_of(1e5, 4, 2, 12), outcome_of(4e6, 5, 3, 12), outcome_of(1e7, 6, 3, 2),
                          outcome_of(1e7, 7, 4, 1)};
    factorial.outcomes.push_back(outcome_of(1e4, 8, 4, 12));
    factorial.outcomes.back().setting.mechanism = Mechanism::builds;
    factorial.outcomes.push_back(outcome_of(1e4, 9, 4, 12));
    factorial.outcomes.back().setting.machine = 1;
    std::vector<std::size_t> bodies;
    for (const Outcome& outcome : outcomes_to_realise(factorial, 3)) bodies.push_back(outcome.setting.bodies);
    EXPECT_THAT(bodies, testing::ElementsAre(7U, 5U, 3U));
}

TEST(ThrashRealised, FaultsAsItsTraceSaysWithTheSameAnswers) {
    Levels levels;
    levels.steps = 12;
    levels.filling = 3;
    Outcome outcome{};
    outcome.figure.vclip_386.fill(7);
    Setting& setting = outcome.setting;
    setting.table = "aos_f64";
    setting.time_step = 1.0 / 60;
    setting.bodies = 30;
    setting.memory_bytes = 1 << 20;
    setting.fault_ns = 2e4;
    const RealisedCell cell = realise(outcome, levels, 1e8);
    if (!cell.reason.empty()) {  // where the kernel refuses, it must say so
        EXPECT_THAT(cell.reason, testing::HasSubstr("userfaultfd"));
        EXPECT_TRUE(cell.curves.empty());
        return;
    }
    ASSERT_EQ(cell.curves.size(), 4U);
    double large_faults = 0;
    for (const RealisedCurve& curve : cell.curves) {
        ASSERT_EQ(curve.points.size(), speeds.size());
        for (const RealisedPoint& point : curve.points) {
            EXPECT_TRUE(point.same_answers);
            EXPECT_EQ(point.model_ns, curve.shape == "sphere386" && curve.algorithm == "vclip" ? 7 : 0);
            EXPECT_GT(point.queries, 0U);
            EXPECT_NEAR(point.hard, point.predicted_hard, 0.02 * point.predicted_hard + 0.02)
                << curve.shape << " " << curve.algorithm << " " << point.speed;
            EXPECT_GE(point.measured_ns, point.hard * setting.fault_ns);
            if (curve.shape == "sphere386" && curve.algorithm == "vclip") large_faults += point.hard;
        }
    }
    EXPECT_GT(large_faults, 1) << "1 MiB is too little for 30 tables of 263 KiB";
}

}  // namespace
}  // namespace edgewise::studies::thrash
