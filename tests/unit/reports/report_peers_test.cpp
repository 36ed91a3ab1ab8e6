// SPDX-License-Identifier: MIT
//
// The chapter beside other libraries from synthetic data: who stands in it, in which order, and to whom
// ratios are.
#include <gmock/gmock.h>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;

/// Of three rounds; theirs where `status` is "judged". No error: it gives verdicts alone.
ReportCell made_up(store::CellStatus status, const std::string& name, double ns,
                   std::optional<double> error) {
    ReportCell cell;
    cell.status = status;
    cell.scene = cell.scene_label = "cold";
    cell.shape = "cube8";
    cell.vertices = 8;
    cell.algorithm = cell.layout = name;
    cell.precision = "f64";
    cell.table = status == store::CellStatus::judged ? name + "_f64" : "lean_f64";
    cell.figures = {{{"separated_ns", ns, "ns"}, "time"},
                    {{"worst_error_stored", error, "1", "no distance"}, "error"}};
    for (int number = 0; number < 3; ++number) {
        measure::Round round{number, {}, {}};
        round.timing.separated_queries = 10;
        round.timing.separated_ns = 10 * ns * (1 + number);  // the machine slows down: ratios do not
        cell.rounds.push_back(round);
    }
    return cell;
}

ReportData made_up_data() {
    ReportData data;
    data.cells = {made_up(store::CellStatus::verified, "vclip", 50, 1e-16),
                  made_up(store::CellStatus::failed, "gjk", 10, 1)};
    data.peers = {made_up(store::CellStatus::judged, "slow", 200, 1e-3),
                  made_up(store::CellStatus::judged, "quick", 100, 1e-16),
                  made_up(store::CellStatus::judged, "verdicts", 20, std::nullopt)};
    return data;
}

TEST(PeerTables, StandFastestFirstWithRatiosToTheFastestThatGivesDistances) {
    const TextGrid grid = peer_grid(made_up_data(), "cold");
    ASSERT_EQ(grid.rows.size(), 4U) << "a cell that failed was not timed";
    const char* const names[] = {"verdicts", "vclip", "quick", "slow"};
    const char* const ratios[] = {"0.20 (0.20 to 0.20)", "0.50 (0.50 to 0.50)", "1.00 (1.00 to 1.00)",
                                  "2.00 (2.00 to 2.00)"};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(grid.rows[i].size(), grid.columns.size());
        EXPECT_EQ(grid.rows[i][2].text, names[i]);
        EXPECT_EQ(grid.rows[i][5].text, ratios[i]);
    }
    EXPECT_THAT(grid.rows[0][6].why, HasSubstr("no distance"));
    EXPECT_EQ(grid.rows[1][3].text, "lean_f64") << "ours with its table type";
    EXPECT_EQ(grid.rows[2][3].text, "f64");
}

TEST(PeerTables, ShowBatchesAndNoOtherAxis) {
    ReportData data = made_up_data();
    for (const char* axes : {"batch=yes", "gap_tolerance=0.01"}) {
        data.cells.push_back(made_up(store::CellStatus::verified, "gjk", 25, 1e-16));
        data.cells.back().axes = axes;
        data.cells.back().table += std::string(" ") + axes;
    }
    const TextGrid grid = peer_grid(data, "cold");
    ASSERT_EQ(grid.rows.size(), 5U);
    EXPECT_EQ(grid.rows[1][3].text, "lean_f64 batch=yes");
    EXPECT_EQ(grid.rows[1][5].text, "0.25 (0.25 to 0.25)");
}

TEST(PeerTables, ShowNoSceneOrShapeWithoutThem) {
    ReportData data = made_up_data();
    EXPECT_TRUE(peer_grid(data, "tumble").rows.empty());
    data.cells.front().shape = "sphere38";
    data.cells.front().vertices = 38;
    for (const auto& row : peer_grid(data, "cold").rows) EXPECT_EQ(row[0].text, "cube8");
    data.peers.clear();
    EXPECT_FALSE(has_peers(data));
    EXPECT_TRUE(peer_grid(data, "cold").rows.empty());
}

TEST(PeerTables, WithVerdictsAloneThereIsNobodyToCompareWith) {
    ReportData data = made_up_data();
    data.peers.erase(data.peers.begin(), data.peers.begin() + 2);
    const TextGrid grid = peer_grid(data, "cold");
    ASSERT_EQ(grid.rows.size(), 2U);
    for (const auto& row : grid.rows) EXPECT_FALSE(row[5].why.empty());
}

}  // namespace
}  // namespace edgewise::reports
