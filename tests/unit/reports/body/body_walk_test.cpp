// SPDX-License-Identifier: MIT
//
// A query's walk read from a store's texts and drawn: features of both bodies, lines of one or two tables,
// several tables of one walk, and what fits no body.
#include <gmock/gmock.h>

#include "edgewise/reports/body/body_heat.hpp"

namespace edgewise::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const HeatBody tetrahedron = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}},
                              {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

nlohmann::json walk(const char* tables = "[20]") {
    return {{"query", 7},
            {"tables", nlohmann::json::parse(tables)},
            {"steps",
             {{{"state", "start"},
               {"a", nlohmann::json::array()},
               {"b", nlohmann::json::array()},
               {"lines", {0, 1}}},
              {{"state", "vertex_edge"}, {"a", {1, 2}}, {"b", {3}}, {"lines", {1, 8}}},
              {{"state", "vertex_face"}, {"a", {1, 2, 3}}, {"b", {3}}, {"lines", {8, 19}}}}}};
}

ReportCell cell_of(const std::string& table, const std::string& algorithm = "vclip") {
    ReportCell cell;
    cell.shape = "tetra4", cell.algorithm = algorithm, cell.table = table, cell.scene_label = "tumble";
    return cell;
}

TEST(BodyWalk, SaysEachStepAndItsLines) {
    std::vector<BodyWalk> walks;
    add_walk(walk(), cell_of("aos_f64"), tetrahedron, walks);
    ASSERT_EQ(walks.size(), 1U);
    EXPECT_EQ(walks[0].title, "V-Clip, tumble, tetra4, query 7");
    EXPECT_THAT(walks[0].said,
                ElementsAre("Step 1 of 3: search for the vertices that face each other.",
                            "Step 2 of 3: edge of A, vertex of B.", "Step 3 of 3: face of A, vertex of B."));
    ASSERT_EQ(walks[0].tables.size(), 1U);
    EXPECT_THAT(walks[0].tables[0].said, ElementsAre("aos_f64: 2 lines, 2 of them new; 2 of 20 so far",
                                                     "aos_f64: 2 lines, 1 of them new; 3 of 20 so far",
                                                     "aos_f64: 2 lines, 1 of them new; 4 of 20 so far"));
    EXPECT_THAT(walks[0].bodies[0].said, ElementsAre("Body A", "Body A: edge 1, 2", "Body A: face 1, 2, 3"));
    EXPECT_EQ(walks[0].bodies[1].said.back(), "Body B: vertex 3");
    EXPECT_EQ(nlohmann::json(walks)[0]["tables"][0]["name"], "aos_f64");
}

/// Seven squares in a row: ceil(sqrt(11 * 4)). A face seen from the other body is in the middle.
TEST(BodyWalk, DrawsLinesInRowsAndTheLastFeatureInTheMiddle) {
    std::vector<BodyWalk> walks;
    add_walk(walk(), cell_of("aos_f64"), tetrahedron, walks);
    const WalkDrawing& table = walks[0].tables[0];
    EXPECT_EQ(table.box, "0 0 7 3");
    EXPECT_EQ(table.ground, "M0 0h7v2h-7zM0 2h6v1h-6z");
    EXPECT_EQ(table.steps[1], "M1 0h.9v.9h-.9zM1 1h.9v.9h-.9z");
    const HeatBody& body = tetrahedron;
    EXPECT_EQ(std::ranges::count(walks[0].bodies[0].ground, 'z'), 1) << "the face 1, 2, 3 hides the others";
    EXPECT_EQ(walks[0].bodies[0].steps[0], "");
    const auto points = seen_points(body, 0, 0);
    EXPECT_EQ(ring_path({3}, points), "M150 270z") << "to the left of the middle and below";
    add_walk(walk("[20,20]"), cell_of("lean_f64"), tetrahedron, walks);
    ASSERT_EQ(walks.size(), 1U) << "the same steps";
}

TEST(BodyWalk, TwoTablesAreOneBelowTheOther) {
    nlohmann::json two = walk("[12,12]");
    two["steps"][2]["lines"] = {8, 12, 23};
    std::vector<BodyWalk> walks;
    add_walk(two, cell_of("aos_f64"), tetrahedron, walks);
    const WalkDrawing& table = walks[0].tables[0];
    EXPECT_EQ(table.box, "0 0 10 5") << "two rows each, and an empty one";
    EXPECT_EQ(table.steps[2], "M8 0h.9v.9h-.9zM0 3h.9v.9h-.9zM1 4h.9v.9h-.9z");
    EXPECT_THAT(table.said[2], HasSubstr("5 of 24 so far"));
}

TEST(BodyWalk, KeepsTheFirstTableFirstAndTheSmallestLast) {
    std::vector<BodyWalk> walks;
    add_walk(walk("[21]"), cell_of("aos_f64"), tetrahedron, walks);
    add_walk(walk("[20]"), cell_of("lean_f64"), tetrahedron, walks);
    add_walk(walk("[90]"), cell_of("aos_padded_f64"), tetrahedron, walks);
    ASSERT_EQ(walks.size(), 1U);
    std::vector<std::string> names;
    for (const WalkDrawing& table : walks[0].tables) names.push_back(table.name);
    EXPECT_THAT(names, ElementsAre("aos_f64", "aos_padded_f64", "lean_f64"));
    add_walk(walk(), cell_of("aos_f64", "gjk"), tetrahedron, walks);
    EXPECT_EQ(walks.size(), 2U);
    EXPECT_THAT(walk_figure(walks[0].tables[0], "lines"), HasSubstr("aos_f64: 2 lines, 1 of them new"));
}

TEST(BodyWalk, WhatFitsNoBodyIsLeftOut) {
    std::vector<BodyWalk> walks;
    const auto with = [](const char* pointer, const char* value) {
        nlohmann::json json = walk();
        json[nlohmann::json::json_pointer(pointer)] = nlohmann::json::parse(value);
        return json;
    };
    for (const nlohmann::json& json :
         {nlohmann::json(), nlohmann::json(7), nlohmann::json::object(), with("/query", "\"7\""),
          with("/tables", "[]"), with("/tables", "[1,2,3]"), with("/tables", "[19]"), with("/steps", "[]"),
          with("/steps/1", "null"), with("/steps/1/state", "1"), with("/steps/1/a", "[4]"),
          with("/steps/1/b", "[\"<script>\"]"), with("/steps/2/lines", "[20]"), with("/steps/2/a", "[]")})
        add_walk(json, cell_of("aos_f64"), tetrahedron, walks);
    EXPECT_TRUE(walks.empty());
}

}  // namespace
}  // namespace edgewise::reports
