// SPDX-License-Identifier: MIT
//
// The tables of the chapter on the paper's figures from synthetic data.
#include <gmock/gmock.h>

#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "paper_data.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;

TEST(PaperTables, StaticHasBothAlgorithmsInOneRow) {
    ReportData data;
    add_scene(data, "paper_static", "");
    data.from_files = {made_up_cell("paper_static", "vclip", "{}", times(400)),
                       made_up_cell("paper_static", "gjk", "{}", times(300))};
    const TextGrid grid = static_grid(data);
    ASSERT_EQ(grid.rows.size(), 1U);
    EXPECT_EQ(grid.rows[0][3].text, "400");
    EXPECT_EQ(grid.rows[0][4].text, "300");
    EXPECT_EQ(grid.rows[0][5].text, "0.750");
    EXPECT_FALSE(grid.rows[0][6].why.empty()) << "builds were not timed";
}

TEST(PaperTables, CostsStandTermByTerm) {
    ReportData data;
    add_scene(data, "paper_bodies", "bodies");
    add_both(data, "paper_bodies", R"({"bodies":100})",
             {{"cost.pairs_per_step", 50}, {"cost.equation_2_ns", 900}, {"cost.step_ns", 1000}});
    const TextGrid grid = cost_grid(data, true);
    ASSERT_EQ(grid.rows.size(), 2U);
    EXPECT_EQ(grid.rows[0].size(), grid.columns.size());
    EXPECT_EQ(grid.rows[0][2].text, "100");
    EXPECT_EQ(grid.rows[0].back().text, "0.900");
    EXPECT_TRUE(cost_grid(data, false).rows.empty());
}

TEST(PaperTables, NeedsAreRatiosToThePlainCell) {
    ReportData data;
    add_scene(data, "paper_needs", "");
    data.from_files = {made_up_cell("paper_needs", "gjk", "{}", times(100)),
                       made_up_cell("paper_needs", "gjk", "{}", times(40))};
    data.from_files[1].axes = "needs=verdict";
    data.from_files[1].table += " needs=verdict";
    const TextGrid grid = needs_grid(data);
    ASSERT_EQ(grid.rows.size(), 2U) << "separated and overlapping";
    EXPECT_EQ(grid.rows[0][4].text, "100");
    EXPECT_EQ(grid.rows[0][5].text, "0.400");
    EXPECT_THAT(grid.rows[0][6].why, HasSubstr("needs=distance"));
}

TEST(PaperTables, StaticTestsStandByBodyAndDistance) {
    ReportData data;
    add_scene(data, "paper_static_gap", "gap");
    const auto add = [&](const char* algorithm, const char* gap, double ns, double steps) {
        MadeUp figures = times(ns);
        figures["error.mean_steps.cold"] = steps;
        data.from_files.push_back(made_up_cell("paper_static_gap", algorithm, gap, figures));
    };
    add("gjk", R"({"gap":1})", 300, 3);
    add("vclip", R"({"gap":1})", 200, 10);
    add("vclip", R"({"gap":0.001})", 80, 4);
    const TextGrid grid = static_gap_grid(data);
    ASSERT_EQ(grid.rows.size(), 2U);
    ASSERT_EQ(grid.rows[0].size(), grid.columns.size());
    EXPECT_EQ(grid.rows[0][3].text, "–") << "no GJK at the smaller gap";
    EXPECT_EQ(grid.rows[1][5].text, "10");
    EXPECT_EQ(grid.rows[1][7].text, "20.000");
    EXPECT_EQ(grid.rows[1][8].text, "100.000");
}

TEST(PaperTables, MarginsStandBesideEachOther) {
    ReportData data;
    add_scene(data, "paper_margin", "margin");
    const auto add = [&](const char* algorithm, const char* margin, double ns) {
        MadeUp figures = times(ns);
        figures.insert({{"error.overlapping", 30}, {"error.checked", 120}, {"work.first_share", 0.125}});
        data.from_files.push_back(made_up_cell("paper_margin", algorithm, margin, figures));
    };
    add("vclip", R"({"margin":0.2})", 120);
    add("gjk", R"({"margin":0.2})", 100);
    add("vclip", R"({"margin":0})", 80);
    add("gjk", R"({"margin":0})", 100);
    const TextGrid grid = margin_grid(data);
    ASSERT_EQ(grid.rows.size(), 2U);
    ASSERT_EQ(grid.rows[0].size(), grid.columns.size());
    EXPECT_EQ(grid.rows[0][2].text, "0");
    EXPECT_EQ(grid.rows[1][2].text, "0.200");
    EXPECT_EQ(grid.rows[0][4].text, "0.250");
    EXPECT_EQ(grid.rows[0][5].text, "0.125");
    EXPECT_EQ(grid.rows[0][6].text, "80");
    EXPECT_EQ(grid.rows[0][8].text, "0.800") << "V-Clip over GJK";
    EXPECT_EQ(grid.rows[1][8].text, "1.200");
}

TEST(PaperTables, TheTolerancesStandBesideEachOther) {
    ReportData data;
    add_scene(data, "paper_tolerance", "rotation_step");
    const auto add = [&](const char* axes, double ns, double separated) {
        MadeUp figures = times(ns);
        figures.insert({{"error.mean_steps.warm", ns / 10}, {"error.separated", separated}});
        if (*axes) figures["error.wrong_verdicts"] = 0;
        data.from_files.push_back(
            made_up_cell("paper_tolerance", "gjk", R"({"rotation_step":0.1})", figures));
        data.from_files.back().axes = axes;
    };
    add("", 100, 90);
    add("contact_tolerance=1e-05", 50, 85);
    const TextGrid grid = tolerance_grid(data);
    ASSERT_EQ(grid.rows.size(), 1U);
    ASSERT_EQ(grid.rows[0].size(), grid.columns.size());
    const std::vector<GridCell>& row = grid.rows[0];
    EXPECT_EQ(row[3].text, "100");
    EXPECT_EQ(row[4].text, "50");
    EXPECT_EQ(row[5].text, "0.500");
    EXPECT_EQ(row[7].text, "5");
    EXPECT_EQ(row[8].text, "90");
    EXPECT_EQ(row[9].text, "85");
    EXPECT_EQ(row[10].text, "0");
}

TEST(PaperTables, NearnessStandsBesideTheOtherNeeds) {
    ReportData data;
    add_scene(data, "paper_needs", "");
    const auto add = [&](const char* axes, const MadeUp& figures) {
        data.from_files.push_back(made_up_cell("paper_needs", "gjk", "{}", figures));
        data.from_files.back().axes = axes;
    };
    add("", {{"time.all_ns", 100}, {"lines.lines_per_query.warm", 9}});
    add("needs=certificate", {{"time.all_ns", 400}});
    add("needs=nearer+margin=1", {{"time.all_ns", 12}});
    add("needs=nearer+margin=0.1",
        {{"time.all_ns", 8}, {"lines.lines_per_query.warm", 0.5}, {"work.told_by_bounds", 0.912}});
    const TextGrid grid = all_needs_grid(data);
    ASSERT_EQ(grid.rows.size(), 4U);
    EXPECT_EQ(grid.rows[0].size(), grid.columns.size());
    EXPECT_EQ(grid.rows[0][3].text, "nearer, margin 0.1");
    EXPECT_EQ(grid.rows[1][3].text, "nearer, margin 1");
    EXPECT_EQ(grid.rows[2][3].text, "witnesses");
    EXPECT_EQ(grid.rows[3][3].text, "certificate");
    EXPECT_EQ(grid.rows[0][4].text, "8");
    EXPECT_EQ(grid.rows[0][5].text, "0.080");
    EXPECT_EQ(grid.rows[0][6].text, "0.500");
    EXPECT_EQ(grid.rows[0][7].text, "0.912");
    EXPECT_FALSE(grid.rows[3][7].why.empty()) << "no bounds were asked";
}

TEST(PaperTables, RobustnessIsInPercentWithItsNumber) {
    ReportData data;
    add_scene(data, "paper_static", "");
    add_both(data, "paper_static", "{}",
             {{"error.checked", 400},
              {"error.wrong_verdicts", 0},
              {"error.control_checked", 200},
              {"error.control_disagreements", 5},
              {"error.control_disagreements_outside_band", 0}});
    const TextGrid grid = robustness_grid(data);
    ASSERT_EQ(grid.rows.size(), 4U) << "each algorithm in all scenes and in the one";
    EXPECT_EQ(grid.rows[0][3].text, "400");
    EXPECT_EQ(grid.rows[0][4].text, "0");
    EXPECT_FALSE(grid.rows[0][5].why.empty()) << "pairs in the band were not counted";
    EXPECT_EQ(grid.rows[0][7].text, "2.5 (5)");
    EXPECT_EQ(grid.rows[0][8].text, "0");
}

}  // namespace
}  // namespace edgewise::reports
