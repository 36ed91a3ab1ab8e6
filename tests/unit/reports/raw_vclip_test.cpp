// SPDX-License-Identifier: MIT
//
// The chapter shows raw V-Clip next to the hardened cell of the same queries; no claim uses raw V-Clip.
#include <gmock/gmock.h>

#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/paper/claims/claims.hpp"
#include "made_up_data.hpp"

namespace edgewise::reports {
namespace {

ReportData static_data(double raw_wrong) {
    ReportData data;
    add_scene(data, "paper_static", "");
    add_both(data, "paper_static", "{}",
             {{"error.checked", 1000},
              {"error.wrong_verdicts", 0},
              {"error.wrong_answers", 0},
              {"error.fallbacks", 7},
              {"error.refinements", 4},
              {"error.cycles", 0}});
    ReportCell raw = made_up_cell("paper_static", "vclip", "{}",
                                  {{"error.checked", 1000},
                                   {"error.wrong_verdicts", raw_wrong},
                                   {"error.wrong_answers", raw_wrong > 0 ? raw_wrong + 5 : 0},
                                   {"error.cycles", 2}});
    raw.table = "aos_f64 hardening=off";
    raw.axes = "hardening=off";
    raw.status = store::CellStatus::judged;
    data.from_files.push_back(raw);
    return data;
}

std::vector<std::string> texts_of(const std::vector<GridCell>& row) {
    std::vector<std::string> texts;
    for (const GridCell& cell : row) texts.push_back(cell.text);
    return texts;
}

TEST(RawVClipGrid, StandsBesideTheHardenedOne) {
    const TextGrid right = raw_vclip_grid(static_data(0)), wrong = raw_vclip_grid(static_data(25));
    ASSERT_EQ(right.rows.size(), 1U);
    EXPECT_THAT(texts_of(right.rows[0]),
                testing::ElementsAre("paper_static", "sphere", "aos_f64 hardening=off", "1000", "0", "0",
                                     "0.003 (3/n)", "2", "0", "11"));
    EXPECT_EQ(wrong.rows[0][4].text, "30");
    EXPECT_EQ(wrong.rows[0][5].text, "25");
    EXPECT_EQ(wrong.rows[0][6].text, "0.03");
}

/// A wrong distance in a hard family counts as a wrong answer; its share is then shown without the bound 3/n.
TEST(RawVClipGrid, CountsWrongDistancesOfFamilies) {
    ReportData data;
    ReportCell raw = made_up_cell("stability", "vclip", "{}",
                                  {{"stability.cases", 100},
                                   {"stability.wrong_outside_band", 0},
                                   {"stability.wrong_answers", 1},
                                   {"stability.cycles", 0}});
    raw.run = "stability";
    raw.axes = "hardening=off";
    raw.table = "aos_f64 hardening=off";
    data.stability.push_back(raw);
    const TextGrid grid = raw_vclip_grid(data);
    ASSERT_EQ(grid.rows.size(), 1U);
    EXPECT_EQ(grid.rows[0][4].text, "1");
    EXPECT_EQ(grid.rows[0][5].text, "0");
    EXPECT_EQ(grid.rows[0][6].text, "0.01");
}

TEST(RawVClipGrid, FailsNoClaim) {
    const auto verdict_of = [](const ReportData& data) {
        for (const Claim& claim : judge_claims(data))
            if (claim.id == "zero_failures_exact") return claim.ours;
        return std::string();
    };
    EXPECT_EQ(verdict_of(static_data(25)), verdict_of(static_data(0)));
    EXPECT_THAT(verdict_of(static_data(25)), testing::HasSubstr("answers checked 2000"));
}

/// A library has its own algorithm and table; its time is compared with V-Clip on the paper's record.
TEST(StaticGrid, HasLibrariesInPlaceOfGjkAndNoRawVClip) {
    ReportData data = static_data(0);
    ReportCell peer = made_up_cell("paper_static", "openGJK", "{}", times(50));
    peer.table = "opengjk_f64";
    peer.status = store::CellStatus::judged;
    for (ReportCell& cell : data.from_files) cell.figures = figures_of(times(100));
    data.from_files.push_back(peer);
    const TextGrid grid = static_grid(data);
    ASSERT_EQ(grid.rows.size(), 2U);
    EXPECT_EQ(grid.rows[0][2].text, "aos_f64");
    EXPECT_EQ(grid.rows[1][2].text, "opengjk_f64");
    EXPECT_EQ(grid.rows[1][3].text, grid.rows[0][3].text);
    EXPECT_EQ(grid.rows[1][5].text, "0.500");
}

}  // namespace
}  // namespace edgewise::reports
