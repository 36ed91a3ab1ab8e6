// SPDX-License-Identifier: MIT
//
// A ranking of cells that several processes measured: intervals and the baseline's own variation are then
// between processes.
#include "edgewise/reports/answer/ranking.hpp"

#include <gtest/gtest.h>

#include "answer_cells.hpp"

namespace edgewise::reports {
namespace {

/// Adds one table type, measured in one process per ratio; rounds within a process spread by 1 %.
void add_processes(ReportData& data, const std::string& layout, const std::vector<double>& ratios,
                   double error = 1e-16) {
    for (const double ratio : ratios)
        data.cells.push_back(
            answer_cell({"vclip", layout, "f64", {0.99 * ratio, ratio, 1.01 * ratio}, error}));
}

SceneRanking ranking_of(const ReportData& data, double limit = 1e-6) {
    return rank_scene(data.swept(), limit, {}, Variation::processes);
}

TEST(Ranking, HasMedianAndIntervalBetweenProcesses) {
    ReportData data;
    add_processes(data, "lean", {0.5, 0.7, 0.6});
    const SceneRanking scene = ranking_of(data);
    ASSERT_EQ(scene.cells.size(), 1U);
    const RankedCell& one = scene.cells.front();
    EXPECT_EQ(one.processes, 3U);
    EXPECT_EQ(one.low(), 0.5);
    EXPECT_EQ(one.ratio, 0.6);
    EXPECT_EQ(one.high(), 0.7);
    EXPECT_DOUBLE_EQ(one.ns, 60);
    EXPECT_EQ(rank_scene(data.swept(), 1, {}, Variation::rounds).cells.size(), 3U) << "each stored cell";
}

TEST(Ranking, HasTheIntervalOfItsRoundsWhereThereIsOneProcess) {
    ReportData data;
    add_processes(data, "lean", {0.6});
    EXPECT_DOUBLE_EQ(ranking_of(data).cells.front().low(), 0.99 * 0.6);
}

TEST(Ranking, TiesWhereIntervalsMeetOrTheBaselineDiffersAsMuchFromItself) {
    ReportData data;
    add_processes(data, "aos", {0.96, 1, 1.05});
    add_processes(data, "lean", {0.50, 0.51, 0.52});        // first
    add_processes(data, "soa", {0.515, 0.56, 0.6});         // its interval meets the first's
    add_processes(data, "hot_cold", {0.525, 0.53, 0.535});  // 0.53 / 0.51 = 1.04 < 1.05
    add_processes(data, "linked", {0.55, 0.56, 0.57});      // 0.56 / 0.51 = 1.10 > 1.05
    const SceneRanking scene = ranking_of(data);
    EXPECT_DOUBLE_EQ(scene.own_variation.high(), 1.05);
    for (const char* table : {"lean_f64", "soa_f64", "hot_cold_f64"})
        EXPECT_TRUE(scene.ties_with_winner(*scene.find("vclip", table))) << table;
    EXPECT_FALSE(scene.ties_with_winner(*scene.find("vclip", "linked_f64")));
    EXPECT_FALSE(scene.ties_with_winner(*scene.baseline()));
    EXPECT_TRUE(scene.beats_baseline);
}

TEST(Ranking, OwnVariationIsThatOfTheLargerSide) {
    ReportData data;
    add_processes(data, "aos", {0.9, 1, 1.01});
    EXPECT_DOUBLE_EQ(ranking_of(data).own_variation.high(), 1 / 0.9);
}

TEST(Ranking, DroppedCellsNeitherWinNorTieAndAreCompared) {
    ReportData data;
    add_processes(data, "quantised", {0.3, 0.3, 0.3}, 1e-5);
    add_processes(data, "lean", {0.6, 0.6, 0.6}, 1e-7);
    add_processes(data, "aos", {1, 1, 1}, 2e-7);
    const SceneRanking scene = ranking_of(data, 1e-7);
    EXPECT_EQ(scene.winner()->table, "lean_f64");
    EXPECT_EQ(scene.ties.size(), 1U);
    ASSERT_TRUE(scene.baseline());
    EXPECT_EQ(scene.baseline()->dropped, "error 2.0e-07 is over 1e-7");
}

}  // namespace
}  // namespace edgewise::reports
