// SPDX-License-Identifier: MIT
//
// Speed against error from synthetic data: which cells stand beside each other, who is on a front, and what
// table and chart say of those that are not drawn.
#include <gmock/gmock.h>

#include <optional>
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/charts/error_axis.hpp"
#include "edgewise/reports/tables/fronts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Of scene "cold" and cube8; theirs where `status` is "judged".
ReportCell front_cell(store::CellStatus status, const std::string& name, double ns, std::optional<double> p50,
                      std::optional<double> p999, std::optional<double> worst, const std::string& axes = {}) {
    ReportCell cell;
    cell.hash = name + axes, cell.status = status;
    cell.scene = cell.scene_label = "cold";
    cell.shape = "cube8", cell.vertices = 8;
    cell.algorithm = status == store::CellStatus::judged ? name : "gjk";
    cell.layout = name, cell.precision = "f64", cell.axes = axes;
    cell.table = name + "_f64" + (axes.empty() ? "" : " " + axes);
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
    EXPECT_TRUE(fronts.panels[0].has_peers());
    EXPECT_EQ(fronts.panels[1].shape, "sphere38");
    EXPECT_EQ(fronts.panels[2].scene_label, "tumble");
    for (const std::size_t i : {1, 2}) EXPECT_TRUE(fronts.panels[i].points.at(0).on_any_front());
}

TEST(Fronts, KnowATolerance) {
    EXPECT_EQ(gap_tolerance_of(front_cell(store::CellStatus::verified, "lean", 1, 0.0, 0.0, 0.0)), "");
    EXPECT_EQ(gap_tolerance_of(
                  front_cell(store::CellStatus::verified, "lean", 1, 0.0, 0.0, 0.0, "gap_tolerance=1e-06")),
              "1e-06");
    EXPECT_EQ(gap_tolerance_of(front_cell(store::CellStatus::verified, "lean", 1, 0.0, 0.0, 0.0,
                                          "gap_tolerance=0.01+order=bfs+batch=yes")),
              "0.01");
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
    EXPECT_NE(chart.spec.dump().find("exactly 0"), std::string::npos);
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

}  // namespace
}  // namespace edgewise::reports
