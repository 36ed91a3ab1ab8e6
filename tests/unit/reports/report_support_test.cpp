// SPDX-License-Identifier: MIT
//
// The verdict on "up to five times": from support queries on a line per vertex and on separate arrays, of the
// same scene, shape, precision and start, and of nothing else.
#include <gtest/gtest.h>

#include <string>

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
    cell.status = "verified";
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

}  // namespace
}  // namespace edgewise::reports
