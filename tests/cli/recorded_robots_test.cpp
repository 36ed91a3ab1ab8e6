// SPDX-License-Identifier: MIT
//
// Recordings of robots: joints move within their limits, links are asked by the model's rules, and SDF, read
// by libsdformat, moves as URDF does in MuJoCo. And what is said about broken files.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

#include "program.hpp"
#include "recorders.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* arm = R"(<robot name="arm">
  <link name="base"><collision><geometry><box size="0.4 0.4 0.1"/></geometry></collision></link>
  <link name="upper"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin xyz="0 0 0.3"/><geometry><mesh filename="package://arm/upper.obj"/></geometry></collision></link>
  <link name="hand"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><box size="0.1 0.2 0.05"/></geometry></collision></link>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
  <joint name="wrist" type="revolute"><parent link="upper"/><child link="hand"/><origin xyz="0 0 0.7"/><axis xyz="0 1 0"/>
    <limit lower="-0.5" upper="0.25" effort="1" velocity="1"/></joint>
</robot>
)";

constexpr const char* tetrahedron =
    "v 0.1 0 -0.25\nv -0.1 0.1 -0.25\nv -0.1 -0.1 -0.25\nv 0 0 0.25\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    return text.replace(text.find(from), from.size(), to);
}

/// Angle about y of the turn from one link to another.
double turn_about_y(const json& from, const json& to) {
    const double turn = 2 * (std::atan2(to[5].get<double>(), to[3].get<double>()) -
                             std::atan2(from[5].get<double>(), from[3].get<double>()));
    return std::remainder(turn, 2 * std::numbers::pi);
}

TEST(RecordedRobot, ARobotMovesItsJointsWithinTheirLimits) {
    if (!has_recorder("record_mujoco")) GTEST_SKIP() << "no MuJoCo here (Debian: libmujoco-dev)";
    const Folder folder;
    folder.write("arm.urdf", arm);
    folder.write("upper.obj", tetrahedron);
    const Outcome recorded = run({"record", "arm.urdf", "--seconds", "20", "--out", "arm.jsonl"}, folder);
    ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
    const auto lines = lines_of(text_of(folder / "arm.jsonl"));
    EXPECT_EQ(json::parse(lines.at(0))["bodies"].size(), 3U);
    double least = 9, most = -9, before = 0, fastest = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const json links = json::parse(lines[i])["poses"];
        const double wrist = turn_about_y(links.at(1), links.at(2));
        least = std::min(least, wrist);
        most = std::max(most, wrist);
        if (i > 1) fastest = std::max(fastest, std::abs(wrist - before));
        before = wrist;
    }
    EXPECT_GE(least, -0.5 - 1e-9);
    EXPECT_LE(most, 0.25 + 1e-9);
    EXPECT_LT(least, -0.4) << "joints use their range";
    EXPECT_GT(most, 0.15);
    EXPECT_NEAR(fastest, 1.0 / 60, 1e-9) << "1 rad/s";
}

/// The robot of arm.urdf, in SDF.
constexpr const char* arm_in_sdf = R"(<sdf version="1.9"><model name="arm">
  <link name="base"><collision name="c"><geometry><box><size>0.4 0.4 0.1</size></box></geometry></collision></link>
  <link name="upper"><collision name="c"><pose>0 0 0.3 0 0 0</pose>
    <geometry><mesh><uri>model://arm/upper.obj</uri></mesh></geometry></collision></link>
  <link name="hand"><pose relative_to="wrist"/>
    <collision name="c"><geometry><box><size>0.1 0.2 0.05</size></box></geometry></collision></link>
  <joint name="shoulder" type="revolute"><parent>base</parent><child>upper</child><axis><xyz>0 1 0</xyz>
    <limit><lower>-2</lower><upper>2</upper></limit></axis></joint>
  <joint name="wrist" type="revolute"><pose relative_to="upper">0 0 0.7 0 0 0</pose>
    <parent>upper</parent><child>hand</child><axis><xyz>0 1 0</xyz>
    <limit><lower>-0.5</lower><upper>0.25</upper></limit></axis></joint>
</model></sdf>
)";

/// The places of links are MuJoCo's, which has kinematics of its own; joints draw the same goals.
TEST(RecordedRobot, ARobotInSdfMovesAsInMujoco) {
    if (!has_recorder("record_mujoco") || !has_recorder("record_sdformat"))
        GTEST_SKIP() << "no MuJoCo or no libsdformat here (Debian: libmujoco-dev libsdformat-dev)";
    const Folder folder;
    folder.write("arm.urdf", arm);
    folder.write("arm.sdf", arm_in_sdf);
    std::filesystem::create_directory(folder / "arm");
    folder.write("arm/upper.obj", tetrahedron);
    folder.write("upper.obj", tetrahedron);
    for (const char* file : {"arm.urdf", "arm.sdf"}) {
        const Outcome recorded =
            run({"record", file, "--seconds", "10", "--out", std::string(file) + ".jsonl"}, folder);
        ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
        EXPECT_EQ(recorded.err, "");
    }
    const auto expected = lines_of(text_of(folder / "arm.urdf.jsonl")),
               lines = lines_of(text_of(folder / "arm.sdf.jsonl"));
    ASSERT_EQ(lines.size(), expected.size());
    double worst = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const json poses = json::parse(lines[i])["poses"], wanted = json::parse(expected[i])["poses"];
        for (std::size_t link = 0; link < 3; ++link)
            for (std::size_t k = 0; k < 7; ++k)
                worst = std::max(worst, std::abs(poses.at(link).at(k).get<double>() -
                                                 wanted.at(link).at(k).get<double>()));
    }
    EXPECT_LT(worst, 1e-12);
    folder.write("near.json", R"({"scene": "recorded", "recording": "arm.sdf.jsonl", "queries": 200,
                                  "parameters": {"margin": 1}})");
    const Outcome swept = run({"sweep", "--scenes", "near.json", "--layouts", "aos_f64", "--algorithms",
                               "gjk", "--rounds", "2", "--store", "s.db", "--no-report"},
                              folder);
    EXPECT_EQ(swept.exit_code, 0) << swept.err;
}

TEST(RecordedRobot, PairsOfAWorldInSdfAreThoseOfItsRules) {
    if (!has_recorder("record_sdformat")) GTEST_SKIP() << "no libsdformat here (Debian: libsdformat-dev)";
    const auto ball = [](const std::string& name, const std::string& bits) {
        return "<link name='" + name +
               "'><collision name='c'><geometry><sphere><radius>1</radius></sphere></geometry>" +
               (bits.empty() ? ""
                             : "<surface><contact><collide_bitmask>" + bits +
                                   "</collide_bitmask></contact></surface>") +
               "</collision></link>";
    };
    const std::string weld = "<joint name='j' type='fixed'><parent>a</parent><child>b</child></joint>";
    const Folder folder;
    folder.write("w.world", "<sdf version='1.9'><world name='w'><model name='quiet'>" + ball("a", "") +
                                ball("b", "") + "</model><model name='self'><self_collide>1</self_collide>" +
                                ball("a", "1") + ball("b", "2") +
                                "</model><model name='one'><static>1</static>" + ball("a", "") +
                                ball("b", "") + weld + "</model></world></sdf>");
    const Outcome recorded = run({"record", "w.world", "--seconds", "0.1", "--out", "w.jsonl"}, folder);
    ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
    const json header = json::parse(lines_of(text_of(folder / "w.jsonl")).at(0));
    const json& bodies = header["bodies"];
    ASSERT_EQ(bodies.size(), 6U);
    EXPECT_EQ(header["excluded"], json::parse("[[1,0]]")) << "links of a model without self_collide";
    EXPECT_EQ(bodies[2]["mask"], 1);
    EXPECT_EQ(bodies[3]["group"], 2);
    EXPECT_EQ(bodies[4]["link"], bodies[5]["link"]) << "welded";
    EXPECT_EQ(bodies[5]["fixed"], true);
    EXPECT_FALSE(bodies[3].contains("fixed"));
}

/// Bad SDF gets one line, and so does an element that SDF does not have, which is left out.
TEST(RecordedRobot, BadSdfGetsOneLine) {
    if (!has_recorder("record_sdformat")) GTEST_SKIP() << "no libsdformat here (Debian: libsdformat-dev)";
    const std::tuple<const char*, const char*, int, const char*> all[] = {
        {"<model name=\"arm\">", "<model name=\"arm\"><bad/", 2, "Line number=1"},
        {"0.4 0.4 0.1", "0.4 x 0.1", 2, "line 2: Error reading element <size>"},
        {"0.4 0.4 0.1", "0.4 0.4 -0.1", 2, "a half extent of a box is below 0"},
        {"<child>hand<", "<child>hend<", 2, "Child frame with name[hend]"},
        {"upper.obj", "uper.obj", 2, "mesh model://arm/uper.obj: no such file"},
        {"</uri>", "</uri><submesh><name>s</name></submesh>", 2, "submesh 's' is not read"},
        {"<box>", "<bx>", 2, ""},
        {"<child>upper<", "<child>hand<", 2, "link 'hand' hangs on two joints"},
        {"<collision name=\"c\"><geometry><box><size>0.1 0.2 0.05</size></box></geometry></collision>",
         "<collison name=\"c\"/>", 0, "collison"}};
    const Folder folder;
    std::filesystem::create_directory(folder / "arm");
    folder.write("arm/upper.obj", tetrahedron);
    for (const auto& [from, to, code, said] : all) {
        folder.write("arm.sdf", replaced(arm_in_sdf, from, to));
        const Outcome outcome = run({"record", "arm.sdf", "--seconds", "0.1", "--out", "a.jsonl"}, folder);
        EXPECT_EQ(outcome.exit_code, code) << said;
        EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
        EXPECT_THAT(outcome.err, AllOf(HasSubstr(said), HasSubstr(code == 0 ? "not defined in SDF" : "")));
    }
}

/// A joint with two axes is often written as two joints with a link between them that has no geometry.
TEST(RecordedRobot, LinksInSdfWithoutGeometryAreNoBodies) {
    if (!has_recorder("record_sdformat")) GTEST_SKIP() << "no libsdformat here (Debian: libsdformat-dev)";
    const Folder folder;
    folder.write("arm.sdf", R"(<sdf version="1.9"><model name="arm">
      <link name="base"><collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link>
      <link name="between"/>
      <link name="hand"><collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link>
      <joint name="a" type="revolute"><parent>base</parent><child>between</child><axis><xyz>0 1 0</xyz></axis></joint>
      <joint name="b" type="revolute"><parent>between</parent><child>hand</child><axis><xyz>1 0 0</xyz></axis></joint>
    </model></sdf>)");
    const Outcome recorded = run({"record", "arm.sdf", "--seconds", "0.1", "--out", "arm.jsonl"}, folder);
    ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
    const auto lines = lines_of(text_of(folder / "arm.jsonl"));
    EXPECT_FALSE(json::parse(lines.at(0))["bodies"].at(1).contains("parent"));
    EXPECT_EQ(json::parse(lines.at(1))["poses"].size(), 2U);
}

TEST(RecordedRobot, WhatARecordingOfMujocoDoesNotFollowIsSaid) {
    if (!has_recorder("record_mujoco")) GTEST_SKIP() << "no MuJoCo here (Debian: libmujoco-dev)";
    const Folder folder;
    folder.write("upper.obj", tetrahedron);
    folder.write("arm.urdf",
                 replaced(arm, "<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 1 0\"/><mimic joint=\"wrist\"/>"));
    folder.write("pair.xml", R"(<mujoco><worldbody>
      <geom name="a" type="box" size="1 1 1" contype="0" conaffinity="0"/><geom type="sphere" size="9" pos="0 0 50"/>
      <body pos="0 0 1.9"><freejoint/><geom name="b" type="sphere" size="1" contype="0" conaffinity="0"/></body>
      </worldbody><contact><pair geom1="a" geom2="b"/></contact></mujoco>)");
    folder.write("stiff.xml", R"(<mujoco><option timestep="0.1"/><worldbody><body>
      <joint type="slide" axis="0 0 1" stiffness="1e5" springref="0.1"/><geom type="sphere" size="0.1" mass="1"/>
      </body></worldbody></mujoco>)");
    const std::tuple<const char*, int, const char*> all[] = {
        {"arm.urdf", 0, "joints that should follow others move by themselves"},
        {"pair.xml", 0, "predefined pairs are left out"},
        {"stiff.xml", 2, "the simulation became unstable: give the model a smaller timestep"}};
    for (const auto& [file, code, said] : all) {
        const Outcome outcome = run({"record", file, "--seconds", "1", "--out", "a.jsonl"}, folder);
        EXPECT_EQ(outcome.exit_code, code) << file;
        EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(said)) << file;
    }
}

TEST(RecordedRobot, LinksOfARobotAreAskedOneByOne) {
    if (!has_recorder("record_mujoco")) GTEST_SKIP() << "no MuJoCo here (Debian: libmujoco-dev)";
    const Folder folder;
    ASSERT_EQ(run({"record", "humanoid.xml", "--joints", "2", "--out", "robot.jsonl"}, folder).exit_code, 0);
    folder.write("links.json", R"({"scene": "recorded", "recording": "robot.jsonl", "queries": 200,
                                   "parameters": {"margin": 1}, "vary": {"link": [-1, 4, 7]}})");
    const Outcome swept = run({"sweep", "--scenes", "links.json", "--layouts", "lean_f64", "--algorithms",
                               "gjk", "--rounds", "2", "--store", "s.db", "--no-report"},
                              folder);
    EXPECT_EQ(swept.exit_code, 0) << swept.err;
    EXPECT_THAT(swept.out, HasSubstr("3 cells: 3 verified, 0 failed"));
}

TEST(RecordedRobot, ABrokenRobotIsOneLineWithItsPlace) {
    if (!has_recorder("record_mujoco")) GTEST_SKIP() << "no MuJoCo here (Debian: libmujoco-dev)";
    const Folder folder;
    folder.write("broken.urdf", replaced(arm, R"(<child link="hand"/>)", R"(<child link="foot"/>)"));
    folder.write("crash.urdf", replaced(arm, "revolute", "sideways"));  // MuJoCo 2.2.2 ends by a signal
    folder.write("upper.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n");
    const Outcome refused = run({"record", "broken.urdf", "--out", "a.jsonl"}, folder);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(lines_of(refused.err).size(), 1U);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("broken.urdf"), HasSubstr("line 9"), Not(HasSubstr("??"))));
    const Outcome crashed = run({"record", "crash.urdf", "--out", "a.jsonl"}, folder);
    EXPECT_EQ(crashed.exit_code, 2);
    EXPECT_THAT(crashed.err, HasSubstr("crash.urdf"));
    EXPECT_EQ(run({"record", "bullet-stack", "--joints", "1", "--out", "a.jsonl"}, folder).exit_code, 2);
}

}  // namespace
}  // namespace edgewise::cli_test
