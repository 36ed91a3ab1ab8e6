// SPDX-License-Identifier: MIT
//
// Heat on the body, read from a store's texts and drawn: what fits no body is left out, what is out of sight
// is not drawn, and a feature's colour is its level.
#include "edgewise/reports/body/body_heat.hpp"

#include <gmock/gmock.h>

#include "edgewise/store/schema.hpp"

namespace edgewise::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A cube with corners at -1 and 1, rings counter-clockwise from outside.
constexpr const char* cube_text =
    R"({"vertices":[-1,-1,-1,1,-1,-1,1,1,-1,-1,1,-1,-1,-1,1,1,-1,1,1,1,1,-1,1,1],
        "edges":[0,1,1,2,2,3,0,3,4,5,5,6,6,7,4,7,0,4,1,5,2,6,3,7],
        "faces":[[0,3,2,1],[4,5,6,7],[0,1,5,4],[2,3,7,6],[1,2,6,5],[0,4,7,3]]})";
constexpr const char* heat_text =
    R"({"queries":10,"vertices":[100,0,10,1,0,0,0,0],"edges":null,"faces":[0,0,0,0,0,5]})";

ReportData body_data(const std::string& heat, const std::string& body = cube_text) {
    ReportData data;
    ReportCell cell;
    cell.hash = "h", cell.shape = "cube8", cell.algorithm = "vclip", cell.table = "aos_f64";
    cell.scene_label = "tumble <x>", cell.status = store::CellStatus::verified, cell.vertices = 8;
    data.cells = {cell};
    data.meta = {{std::string(store::body_key) + "cube8", body}, {std::string(store::heat_key) + "h", heat}};
    return data;
}

TEST(BodyHeat, IsReadsPerQuery) {
    const ReportData data = body_data(heat_text);
    const HeatOnBodies found = heat_on_bodies(data);
    ASSERT_EQ(found.heats.size(), 1U);
    const BodyHeat& heat = found.heats.front();
    EXPECT_THAT(*heat.vertices, ElementsAre(10, 0, 1, 0.1, 0, 0, 0, 0));
    EXPECT_FALSE(heat.edges);
    EXPECT_EQ(heat.title(), "V-Clip on aos_f64, tumble <x>, cube8");
    EXPECT_EQ(heat.sentence(),
              "3 of 8 vertices were read, number 0 the most, 10 times per query; nothing is stored of edges "
              "alone; 1 of 6 faces were read, number 5 the most, 0.500 times per query.");
}

TEST(BodyHeat, WhatFitsNoBodyIsLeftOut) {
    for (const char* heat : {"", "[]", "{}", R"({"queries":0,"vertices":[1,1,1,1,1,1,1,1]})",
                             R"({"queries":1,"vertices":[1]})", R"({"queries":1,"vertices":["<script>"]})",
                             R"({"queries":1,"vertices":null,"edges":null,"faces":null})"})
        EXPECT_TRUE(heat_on_bodies(body_data(heat)).heats.empty()) << heat;
    for (const char* body : {"", "7", R"({"vertices":[0,0],"edges":[],"faces":[]})",
                             R"({"vertices":[0,0,0],"edges":[0,1],"faces":[]})",
                             R"({"vertices":[0,0,0],"edges":[0,-1],"faces":[]})",
                             R"({"vertices":[0,0,0],"edges":[],"faces":[[0,0]]})"})
        EXPECT_TRUE(heat_on_bodies(body_data(heat_text, body)).heats.empty()) << body;
}

TEST(BodyHeat, LevelsAreLogarithmic) {
    EXPECT_EQ(heat_level(0, 10), 0U);
    EXPECT_EQ(heat_level(0.01, 10), 1U) << "a thousandth";
    EXPECT_EQ(heat_level(0.1, 10), 1U) << "a hundredth";
    EXPECT_EQ(heat_level(1, 10), 3U) << "half of the way";
    EXPECT_EQ(heat_level(10, 10), 5U);
}

/// Three faces, nine edges and seven vertices of a cube are visible.
TEST(BodyHeat, ThePictureHasWhatIsInSightInItsColour) {
    const ReportData data = body_data(heat_text);
    const HeatOnBodies found = heat_on_bodies(data);
    const std::string svg = body_svg(found.bodies.at("cube8"), found.heats.front());
    const auto part = [&](const std::string& style) {
        const auto at = svg.find("<path class=\"" + style + "\" d=\"");
        if (at == svg.npos) return std::string("none");
        const auto from = svg.find(" d=\"", at) + 4;
        return svg.substr(from, svg.find('"', from) - from);
    };
    const auto count = [](const std::string& text, char c) {
        return std::count(text.begin(), text.end(), c);
    };
    long faces = 0, vertices = 0;
    for (int level = 0; level < 6; ++level) {
        faces += count(part("face h" + std::to_string(level)), 'z');
        vertices += count(part("vertex h" + std::to_string(level)), 'M');
    }
    EXPECT_EQ(faces, 3);
    EXPECT_EQ(vertices, 7);
    EXPECT_EQ(count(part("edge hx"), 'M'), 9) << "nothing is stored of edges: drawn plain";
    EXPECT_THAT(svg, HasSubstr("tumble &lt;x&gt;"));
    const std::string packed = bodies_data(found);
    EXPECT_THAT(packed, HasSubstr(R"("shape":"cube8")"));
    EXPECT_THAT(packed, HasSubstr(R"("edges":null)"));
}

}  // namespace
}  // namespace edgewise::reports
