// SPDX-License-Identifier: MIT
//
// The four facts of figure 8: each fails by itself, at both ends where it has two.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "edgewise/studies/thrash/factorial.hpp"
#include "edgewise/studies/thrash/thrash_rows.hpp"

namespace edgewise::studies::thrash {
namespace {

SpeedCurve flat(double ns) {
    SpeedCurve curve;
    curve.fill(ns);
    return curve;
}

/// Returns figure 8 as the paper draws it: V-Clip goes up and down below 1.2 ms, GJK is at the bottom.
Figure8 papers_figure() {
    return {flat(7e4), flat(9e4), {9e5, 6e5, 1.1e6, 8e5, 1e6, 7e5, 1e6}, flat(7e4), flat(1e5), flat(1e5)};
}

std::array<bool, 4> all_but(Fact fact) {
    std::array<bool, 4> facts = {true, true, true, true};
    facts[static_cast<std::size_t>(fact)] = false;
    return facts;
}

TEST(Figure8Facts, HoldForThePapersFigure) {
    const FactScore found = score(papers_figure());
    EXPECT_EQ(found.count(), 4);
    EXPECT_EQ(found.mask(), 15U);
    EXPECT_NEAR(found.rise, 1.1e6 / 9e4, 1e-12);
    EXPECT_EQ(found.top_ns, 1.1e6);
    EXPECT_EQ(found.gjk_rise, 1);
    EXPECT_NEAR(found.gjk_rise_from_8, 1e5 / 7e4, 1e-12);
    EXPECT_NEAR(found.fall, 1.1e6 / 7e5, 1e-12);
}

TEST(Figure8Facts, FailAloneByTheRise) {
    for (const double small : {1.1e6 / 25, 1.1e6 / 5}) {
        Figure8 figure = papers_figure();
        figure.vclip_38 = flat(small);
        EXPECT_EQ(score(figure).holds, all_but(Fact::rises)) << small;
    }
}

TEST(Figure8Facts, FailAloneByTheTime) {
    for (const double factor : {0.5, 1.2}) {
        Figure8 figure = papers_figure();
        for (double& ns : figure.vclip_386) ns *= factor;
        for (double& ns : figure.vclip_38) ns *= factor;
        EXPECT_EQ(score(figure).holds, all_but(Fact::takes_as_long)) << factor;
    }
}

TEST(Figure8Facts, FailAloneByGjk) {
    for (const double ns : {2.1e5, 4.9e4}) {
        Figure8 figure = papers_figure();
        figure.gjk_386 = flat(ns);
        EXPECT_EQ(score(figure).holds, all_but(Fact::spares_gjk)) << ns;
    }
}

TEST(Figure8Facts, FailAloneWithoutUpsAndDowns) {
    Figure8 figure = papers_figure();
    figure.vclip_386 = {5e5, 6e5, 7e5, 8e5, 9e5, 1e6, 1.1e6};
    EXPECT_EQ(score(figure).holds, all_but(Fact::erratic));
    figure = papers_figure();
    figure.gjk_386 = {1e5, 7e4, 1e5, 1e5, 1e5, 1e5, 1e5};  // as erratic as V-Clip
    EXPECT_EQ(score(figure).holds, all_but(Fact::erratic));
}

TEST(Figure8Facts, FindTheLargestFallOverAnyDistance) {
    EXPECT_NEAR(largest_fall({1, 4, 3, 5, 2, 6, 7}), 2.5, 1e-12);
    EXPECT_LT(largest_fall({1, 2, 3, 4, 5, 6, 7}), 1);
}

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
            EXPECT_NEAR(point.faults, point.predicted_faults, 0.02 * point.predicted_faults + 0.02)
                << curve.shape << " " << curve.algorithm << " " << point.speed;
            EXPECT_GE(point.measured_ns, point.faults * setting.fault_ns);
            if (curve.shape == "sphere386" && curve.algorithm == "vclip") large_faults += point.faults;
        }
    }
    EXPECT_GT(large_faults, 1) << "1 MiB is too little for 30 tables of 263 KiB";
}

}  // namespace

}  // namespace edgewise::studies::thrash
