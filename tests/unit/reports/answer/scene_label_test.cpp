// SPDX-License-Identifier: MIT
//
// A scene is called the same in every store: by what differs from its kind's standard scene, or by what its
// file varies.
#include "edgewise/reports/reader.hpp"

#include <gtest/gtest.h>

namespace edgewise::reports {
namespace {

store::CellRow row(const std::string& scene, const std::string& parameters) {
    store::CellRow cell;
    cell.scene = scene, cell.scene_parameters = parameters;
    return cell;
}

TEST(SceneLabel, SaysWhatDiffersFromTheStandardScene) {
    EXPECT_EQ(scene_label(row("static", R"({"bodies":64.0,"margin":0.0,"occupancy":0.1})")), "static");
    EXPECT_EQ(scene_label(row("tumble", R"({"bodies":12,"rotation_step":0.01})")),
              "tumble (rotation_step 0.01)");
    EXPECT_EQ(scene_label(row("tumble", R"({"bodies":100,"in_time_order":1,"rotation_step":0.1})")),
              "tumble (bodies 100, in_time_order 1, rotation_step 0.1)");
    EXPECT_EQ(scene_label(row("pressure", R"({"bodies":600})")), "pressure (bodies 600)");
    EXPECT_EQ(scene_label(row("mystery", R"({"a":1})")), "mystery (a 1)");
    EXPECT_EQ(scene_label(row("static", "no JSON")), "static (parameters no JSON)");
}

TEST(SceneLabel, OfAFileSaysWhatItVaries) {
    const std::string varied = R"({"scene":"tumble","vary":{"bodies":[3,12]}})";
    EXPECT_EQ(scene_label(row("mine", R"({"bodies":3,"rotation_step":0.5})"), varied), "mine (bodies 3)");
    EXPECT_EQ(scene_label(row("mine", R"({"bodies":3})"), R"({"scene":"tumble"})"), "mine");
    // A velocity is varied, which the cell's parameters have as a turn per step.
    const std::string velocity = R"({"scene":"tumble","vary":{"angular_velocity":[1,2]}})";
    EXPECT_EQ(scene_label(row("mine", R"({"bodies":12,"rotation_step":0.0166})"), velocity),
              "mine (rotation_step 0.0166)");
}

TEST(SceneLabel, NumbersOfAScene) {
    EXPECT_EQ(parameter_of(row("tumble", R"({"bodies":3})"), "bodies"), 3.0);
    EXPECT_FALSE(parameter_of(row("tumble", R"({"bodies":"three"})"), "bodies"));
    EXPECT_FALSE(parameter_of(row("tumble", "[]"), "bodies"));
}

}  // namespace
}  // namespace edgewise::reports
