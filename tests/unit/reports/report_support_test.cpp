// SPDX-License-Identifier: MIT
//
// The verdict on "up to five times": from support queries on a line per vertex and on separate arrays, of the
// same scene, shape, precision and start, and of nothing else. And the seed curve: tables with seeds beside
// the one without, of the same scene, shape, algorithm and precision, where all queries start far from their
// answers.
#include <gtest/gtest.h>

#include <string>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {
namespace {

void add_supports(ReportData& data, const std::string& layout, const std::string& shape, double cold,
                  double warm, const std::string& axes = {}) {
    ReportCell cell;
    cell.scene = cell.scene_label = "cold";
    cell.shape = shape;
    cell.algorithm = "gjk";
    cell.layout = layout;
    cell.precision = "f64";
    cell.table = layout + "_f64" + axes;
    cell.status = store::CellStatus::verified;
    cell.figures.push_back({{"query_ns.cold", cold, "ns", {}, {}}, "support"});
    cell.figures.push_back({{"query_ns.warm", warm, "ns", {}, {}}, "support"});
    data.cells.push_back(cell);
}

TEST(SupportClaim, IsNotMeasuredWithoutBothLayouts) {
    ReportData data;
    add_supports(data, "line_per_vertex", "sphere386", 10, 10);
    add_supports(data, "aos", "sphere38", 100, 100);
    EXPECT_NE(support_verdict(data).find("not measured"), std::string::npos);
    EXPECT_TRUE(support_grid(data).rows.empty());
}

TEST(SupportClaim, HoldsFromFiveTimesOn) {
    ReportData data;
    add_supports(data, "line_per_vertex", "sphere386", 10, 10);
    add_supports(data, "aos", "sphere386", 49, 8);
    add_supports(data, "aos", "sphere386", 900, 900, " order=bfs");
    EXPECT_EQ(support_grid(data).rows.size(), 2U);
    EXPECT_NE(
        support_verdict(data).find("not held; at most 4.90 times as fast (cold, sphere386, f64, cold start), "
                                   "and slower in 1 of 2 comparisons"),
        std::string::npos)
        << support_verdict(data);
    add_supports(data, "line_per_vertex", "sphere38", 10, 10);
    add_supports(data, "aos", "sphere38", 20, 50);
    EXPECT_NE(support_verdict(data).find("Verdict: held; at most 5.00"), std::string::npos)
        << support_verdict(data);
}

ReportCell seed_cell(const std::string& scene, const std::string& layout, double table_bytes, double steps) {
    ReportCell cell;
    cell.scene = cell.scene_label = scene;
    cell.shape = "sphere386";
    cell.shape_source = "built-in";
    cell.vertices = 386;
    cell.algorithm = "vclip";
    cell.layout = layout;
    cell.precision = "f64";
    cell.table = layout + "_f64";
    cell.status = store::CellStatus::verified;
    cell.figures.push_back({{"table_bytes", table_bytes, "B", {}, {}}, "bytes"});
    cell.figures.push_back({{"mean_steps", steps, "steps", {}, {}}, "error"});
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
