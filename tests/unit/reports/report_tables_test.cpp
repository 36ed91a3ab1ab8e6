// SPDX-License-Identifier: MIT
//
// Tables and charts from synthetic data. Speed against error: which cells are compared, which are on a front,
// and what table and chart say of cells that are not drawn. Other libraries: which, in which order, and what
// ratios are to. The verdict on "up to five times": support queries on a line per vertex and on separate
// arrays, of the same scene, shape, precision and start. And the seed curve: tables with seeds next to the
// table without, where all queries start far from their answers.
#include <gmock/gmock.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "made_up_data.hpp"

namespace edgewise::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Returns a cell of scene "cold" and cube8; it is of another library if `status` is "judged".
ReportCell front_cell(store::CellStatus status, const std::string& name, double ns, std::optional<double> p50,
                      std::optional<double> p999, std::optional<double> worst, const std::string& axes = {}) {
    ReportCell cell =
        base_cell("cold", "cube8", status == store::CellStatus::judged ? name : "gjk", name, status);
    cell.hash = name + axes, cell.axes = axes;
    if (!axes.empty()) cell.table += " " + axes;
    cell.figures = {{{"separated_ns", ns, "ns"}, "time"},
                    {{"p50_error_given", p50, "scale", "no distance"}, "error"},
                    {{"p999_error_given", p999, "scale", "too few"}, "error"},
                    {{"worst_error_given", worst, "scale", "verdicts alone"}, "error"}};
    return cell;
}

ReportData front_data() {
    ReportData data;
    data.cells = {
        front_cell(store::CellStatus::verified, "lean", 50, 0.0, 1e-16, 2e-16),
        front_cell(store::CellStatus::verified, "aos", 60, 1e-17, 1e-16, 1e-16),
        front_cell(store::CellStatus::verified, "soa", 70, 1e-17, 1e-15, 1e-15),
        front_cell(store::CellStatus::verified, "lean", 20, 1e-4, std::nullopt, 1e-3, "gap_tolerance=0.01"),
        front_cell(store::CellStatus::verified, "lean", 1, 0.0, 0.0, 0.0, "order=bfs+needs=verdict"),
        front_cell(store::CellStatus::failed, "aos", 1, 0.0, 0.0, 0.0)};
    data.peers = {
        front_cell(store::CellStatus::judged, "quick", 30, 1e-6, 1e-5, 1e-4),
        front_cell(store::CellStatus::judged, "verdicts", 5, std::nullopt, std::nullopt, std::nullopt)};
    return data;
}

std::vector<std::string> column(const TextGrid& grid, const std::string& title) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < grid.columns.size(); ++i)
        if (grid.columns[i].title == title)
            for (const auto& row : grid.rows) texts.push_back(row.at(i).text);
    return texts;
}

TEST(Fronts, LeaveRawVClipOutThoughItIsJudged) {
    ReportData data = front_data();
    const std::size_t points = fronts_of(data).panels.at(0).points.size();
    data.cells.push_back(front_cell(store::CellStatus::judged, "aos", 1, 0.0, 0.0, 0.0, "hardening=off"));
    const Fronts fronts = fronts_of(data);
    EXPECT_EQ(fronts.panels.at(0).points.size(), points);
    EXPECT_THAT(fronts.left_out,
                testing::Contains(testing::Pair(&data.cells.back(), HasSubstr("raw V-Clip"))));
}

TEST(Fronts, AreOfEachErrorAndHoldOtherLibrariesAndTolerances) {
    const TextGrid grid = front_grid(front_data(), "");
    EXPECT_THAT(column(grid, "table type or precision"),
                ElementsAre("lean_f64 gap_tolerance=0.01", "f64", "lean_f64", "aos_f64"));
    EXPECT_THAT(column(grid, "algorithm or library"), ElementsAre("gjk", "quick", "gjk", "gjk"));
    EXPECT_THAT(column(grid, "on the front of"),
                ElementsAre("p50, worst", "p50, p99.9, worst", "p50, p99.9, worst", "worst"))
        << "no p99.9, so on no front of it; aos is slower at the same p99.9";
    EXPECT_THAT(column(grid, "cells compared"), ElementsAre("5", "5", "5", "5"));
    for (const auto& row : grid.rows) EXPECT_EQ(row.size(), grid.columns.size());
    EXPECT_TRUE(front_grid(front_data(), "sphere38").rows.empty());
}

TEST(Fronts, LeaveOutWhatCannotBeComparedAndSayWhy) {
    const TextGrid grid = left_out_grid(front_data());
    EXPECT_THAT(column(grid, "algorithm or library"), ElementsAre("gjk", "verdicts"));
    EXPECT_THAT(column(grid, "why"), ElementsAre("its axis asks another question", "error: verdicts alone"));
}

TEST(Fronts, AreOfOneSceneAndShape) {
    ReportData data = front_data();
    ReportCell slow = front_cell(store::CellStatus::verified, "aos", 1000, 1e-2, 1e-2, 1e-2);
    slow.shape = "sphere38", slow.vertices = 38;
    data.cells.push_back(slow);
    slow.scene = slow.scene_label = "tumble", slow.shape = "cube8", slow.vertices = 8;
    data.cells.push_back(slow);
    const Fronts fronts = fronts_of(data);
    ASSERT_EQ(fronts.panels.size(), 3U);
    EXPECT_TRUE(std::ranges::any_of(fronts.panels[0].points, [](const auto& p) { return p.cell->judged(); }));
    EXPECT_EQ(fronts.panels[1].shape, "sphere38");
    EXPECT_EQ(fronts.panels[2].scene_label, "tumble");
    for (const std::size_t i : {1, 2}) EXPECT_TRUE(fronts.panels[i].points.at(0).on_any_front());
}

TEST(Fronts, KnowATolerance) {
    const auto tolerance_of = [](const char* axes) {
        return front_cell(store::CellStatus::verified, "lean", 1, 0.0, 0.0, 0.0, axes).axis("gap_tolerance");
    };
    EXPECT_EQ(tolerance_of(""), std::nullopt);
    EXPECT_EQ(tolerance_of("gap_tolerance=1e-06"), "1e-06");
    EXPECT_EQ(tolerance_of("gap_tolerance=0.01+order=bfs+batch=yes"), "0.01");
}

TEST(SpeedError, DrawsEveryPointAndSaysWhatIsNotDrawn) {
    const Chart chart = speed_error_chart(front_data());
    const auto& values = chart.spec["data"]["values"];
    ASSERT_EQ(values.size(), 5U);
    EXPECT_EQ(values[0]["table"], "lean_f64 gap_tolerance=0.01") << "fastest first";
    EXPECT_EQ(values[0]["tolerance"], "0.01");
    EXPECT_EQ(values[0]["label"], "gap 0.01");
    EXPECT_TRUE(values[0]["p999"].is_null() && values[0]["p999_drawn"].is_null());
    EXPECT_FALSE(values[2].contains("tolerance"));
    EXPECT_EQ(values[1]["kind"], "another library");
    std::set<std::string> on_worst;
    for (const auto& row : values)
        if (row["worst_front"] == true) on_worst.insert(row["holder"].get<std::string>());
    EXPECT_EQ(on_worst, (std::set<std::string>{"aos", "lean", "quick"}));
    EXPECT_THAT(chart.notes, testing::IsSupersetOf({HasSubstr("1 cell (error: verdicts alone)"),
                                                    HasSubstr("1 cell (its axis asks another question)"),
                                                    HasSubstr("1 of 5 points have no p99.9 error")}));
}

TEST(SpeedError, WritesAToleranceBesideTheFastestOfIt) {
    ReportData data;
    for (const double ns : {30.0, 10.0, 20.0})
        data.cells.push_back(
            front_cell(store::CellStatus::verified, "lean", ns, 0.0, 0.0, 1e-3, "gap_tolerance=0.01"));
    data.cells.push_back(
        front_cell(store::CellStatus::verified, "lean", 40, 0.0, 0.0, 1e-5, "gap_tolerance=0.0001"));
    const Chart chart = speed_error_chart(data);
    std::vector<double> labelled, tolerant;
    for (const auto& row : chart.spec["data"]["values"]) {
        if (row.contains("tolerance")) tolerant.push_back(row["ns"]);
        if (row.contains("label")) labelled.push_back(row["ns"]);
    }
    EXPECT_THAT(labelled, ElementsAre(10, 40));
    EXPECT_THAT(tolerant, ElementsAre(10, 20, 30, 40));
}

TEST(SpeedError, ExactZerosStandOnALabelledFloor) {
    const Chart chart = speed_error_chart(front_data());
    for (const auto& row : chart.spec["data"]["values"]) {
        if (row["p50"] == 0) {
            EXPECT_GT(row["p50_drawn"], 0.0);
            EXPECT_LT(row["p50_drawn"], 1e-17);
        } else {
            EXPECT_EQ(row["p50_drawn"], row["p50"]);
        }
    }
    EXPECT_THAT(chart.spec.dump(), HasSubstr("exactly 0"));
    EXPECT_THAT(chart.notes, testing::Contains(HasSubstr("1 of 5 points have a p50 error of exactly 0")));
}

TEST(SpeedError, LeavesScenesBeyondTwelveToTheTableAndShowsTheReferenceShapeFirst) {
    ReportData data;
    for (int scene = 0; scene < 15; ++scene) {
        for (const char* shape : {"cube8", "sphere386"}) {
            ReportCell cell = front_cell(store::CellStatus::verified, "lean", 10, 1e-16, 1e-16, 1e-16);
            cell.scene = cell.scene_label = "scene" + std::to_string(10 + scene);
            cell.shape = shape, cell.vertices = shape[0] == 'c' ? 8 : 386;
            data.cells.push_back(cell);
        }
    }
    const Chart chart = speed_error_chart(data);
    EXPECT_EQ(chart.spec["data"]["values"].size(), 24U);
    EXPECT_THAT(chart.notes, testing::Contains(HasSubstr("6 cells (of scenes beyond the first 12")));
    EXPECT_EQ(front_grid(data, "").rows.size(), 30U);
    EXPECT_EQ(chart.spec["params"][0]["value"], "sphere386");
    EXPECT_EQ(chart.spec["params"][0]["bind"]["options"], (ChartJson{"cube8", "sphere386"}));
}

TEST(ErrorAxis, HasTicksInsideAndAFloorOnlyForZeros) {
    const ErrorAxis plain({3e-3, 2e-9});
    EXPECT_FALSE(plain.has_zeros());
    EXPECT_EQ(plain.ticks(), (ChartJson{1e-8, 1e-6, 1e-4}));
    EXPECT_EQ(plain.domain(), (ChartJson{2e-9, 3e-3}));
    const ErrorAxis zeros({0, 2e-9, 3e-19});
    EXPECT_LT(zeros.floor(), 3e-20);
    EXPECT_EQ(zeros.domain()[0], zeros.floor());
    EXPECT_EQ(zeros.ticks()[0], zeros.floor());
    for (const auto& tick : zeros.ticks()) EXPECT_LE(tick, 2e-9);
    EXPECT_EQ(ErrorAxis({0}).ticks().size(), 1U);
}

/// Returns a cell with three rounds, of another library if `status` is "judged". No error: verdicts only.
ReportCell peer_cell(store::CellStatus status, const std::string& name, double ns,
                     std::optional<double> error) {
    ReportCell cell = base_cell("cold", "cube8", name, name, status);
    if (status != store::CellStatus::judged) cell.table = "lean_f64";
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

ReportData peer_data() {
    ReportData data;
    data.cells = {peer_cell(store::CellStatus::verified, "vclip", 50, 1e-16),
                  peer_cell(store::CellStatus::failed, "gjk", 10, 1)};
    data.peers = {peer_cell(store::CellStatus::judged, "slow", 200, 1e-3),
                  peer_cell(store::CellStatus::judged, "quick", 100, 1e-16),
                  peer_cell(store::CellStatus::judged, "verdicts", 20, std::nullopt)};
    return data;
}

TEST(PeerTables, StandFastestFirstWithRatiosToTheFastestThatGivesDistances) {
    const TextGrid grid = peer_grid(peer_data(), "cold");
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
    ReportData data = peer_data();
    for (const char* axes : {"batch=yes", "gap_tolerance=0.01"}) {
        data.cells.push_back(peer_cell(store::CellStatus::verified, "gjk", 25, 1e-16));
        data.cells.back().axes = axes;
        data.cells.back().table += std::string(" ") + axes;
    }
    const TextGrid grid = peer_grid(data, "cold");
    ASSERT_EQ(grid.rows.size(), 5U);
    expect_texts(grid.rows[1], {{3, "lean_f64 batch=yes"}, {5, "0.25 (0.25 to 0.25)"}});
}

TEST(PeerTables, ShowNoSceneOrShapeWithoutThem) {
    ReportData data = peer_data();
    EXPECT_TRUE(peer_grid(data, "tumble").rows.empty());
    data.cells.front().shape = "sphere38";
    data.cells.front().vertices = 38;
    for (const auto& row : peer_grid(data, "cold").rows) EXPECT_EQ(row[0].text, "cube8");
    data.peers.clear();
    EXPECT_TRUE(peer_grid(data, "cold").rows.empty());
}

TEST(PeerTables, WithVerdictsAloneThereIsNobodyToCompareWith) {
    ReportData data = peer_data();
    data.peers.erase(data.peers.begin(), data.peers.begin() + 2);
    const TextGrid grid = peer_grid(data, "cold");
    ASSERT_EQ(grid.rows.size(), 2U);
    for (const auto& row : grid.rows) EXPECT_FALSE(row[5].why.empty());
}

void add_supports(ReportData& data, const std::string& layout, const std::string& shape, double cold,
                  double warm, const std::string& axes = {}) {
    ReportCell cell = base_cell("cold", shape, "gjk", layout);
    cell.table += axes;
    cell.figures = figures_of(MadeUp{{"support.query_ns.cold", cold}, {"support.query_ns.warm", warm}});
    data.cells.push_back(cell);
}

TEST(SupportClaim, IsNotMeasuredWithoutBothLayouts) {
    ReportData data;
    add_supports(data, "line_per_vertex", "sphere386", 10, 10);
    add_supports(data, "aos", "sphere38", 100, 100);
    EXPECT_THAT(support_verdict(data), HasSubstr("not measured"));
    EXPECT_TRUE(support_grid(data).rows.empty());
}

TEST(SupportClaim, HoldsFromFiveTimesOn) {
    ReportData data;
    add_supports(data, "line_per_vertex", "sphere386", 10, 10);
    add_supports(data, "aos", "sphere386", 49, 8);
    add_supports(data, "aos", "sphere386", 900, 900, " order=bfs");
    EXPECT_EQ(support_grid(data).rows.size(), 2U);
    EXPECT_THAT(support_verdict(data),
                HasSubstr("not held; at most 4.90 times as fast (cold, sphere386, f64, cold start), "
                          "and slower in 1 of 2 comparisons"))
        << support_verdict(data);
    add_supports(data, "line_per_vertex", "sphere38", 10, 10);
    add_supports(data, "aos", "sphere38", 20, 50);
    EXPECT_THAT(support_verdict(data), HasSubstr("Verdict: held; at most 5.00")) << support_verdict(data);
}

ReportCell seed_cell(const std::string& scene, const std::string& layout, double table_bytes, double steps) {
    ReportCell cell = base_cell(scene, "sphere386", "vclip", layout);
    cell.figures = figures_of(MadeUp{{"bytes.table_bytes", table_bytes}, {"error.mean_steps", steps}});
    return cell;
}

TEST(SeedCurve, ComparesTablesThatDifferInSeedsAlone) {
    ReportData data;
    data.cells = {seed_cell("cold", "lean_seeds", 14826, 9),     seed_cell("cold", "lean", 14772, 50),
                  seed_cell("cold", "lean_seeds1536", 17844, 4), seed_cell("cold", "aos", 1, 1),
                  seed_cell("tumble", "lean", 14772, 3),         seed_cell("tumble", "lean_seeds", 14826, 3)};
    const auto cells = seeded_cells(data);
    ASSERT_EQ(cells.size(), 3U) << "tumble keeps close to its last answers";
    EXPECT_EQ(cells[0].cell->layout, "lean");
    EXPECT_EQ(cells[0].seed_bytes, 0);
    EXPECT_EQ(cells[1].seed_bytes, 54);
    EXPECT_EQ(cells[2].seed_bytes, 3072);
    const TextGrid grid = seeds_grid(data);
    ASSERT_EQ(grid.rows.size(), 3U);
    EXPECT_EQ(grid.rows[0][4].text, "0");
    EXPECT_EQ(grid.rows[1][6].text, "9.00");
    for (ReportCell& cell : data.cells) cell.scene_parameters = R"({"random_orientation":1})";
    EXPECT_EQ(seeded_cells(data).size(), 5U);
}

TEST(SeedCurve, NeedsATableWithoutSeeds) {
    ReportData data;
    data.cells = {seed_cell("cold", "lean_seeds", 14826, 9)};
    EXPECT_TRUE(seeded_cells(data).empty());
    EXPECT_TRUE(seeds_grid(data).rows.empty());
    data.cells.push_back(seed_cell("cold", "lean", 14772, 50));
    data.cells.back().status = store::CellStatus::failed;
    EXPECT_TRUE(seeded_cells(data).empty());
}

TEST(SeedCurve, DrawsEachNumberThatWasMeasured) {
    ReportData data;
    data.cells = {seed_cell("cold", "lean_seeds", 14826, 9), seed_cell("cold", "lean", 14772, 50)};
    const Chart chart = seeds_chart(data);
    ASSERT_FALSE(chart.spec.is_null());
    EXPECT_EQ(chart.points.size(), 2U);
    EXPECT_EQ(chart.points[1]["seed_bytes"], 54);
    EXPECT_EQ(chart.points[1]["value"], 9);
    EXPECT_FALSE(chart.notes.empty()) << "times and lines are missing here";
}

}  // namespace

}  // namespace edgewise::reports
