// SPDX-License-Identifier: MIT
//
// The pages followed: the steps of docs/your_engine.md (record, sweep, read, lock), and each user's commands.
// And the messages about an engine that is not installed, a changed recording, and commands that take no
// recording.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "cli_paths.hpp"
#include "edgewise/record.hpp"
#include "program.hpp"
#include "recorders.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

/// The command lines of a page, without the program's name.
std::vector<std::string> commands_of(const std::filesystem::path& page) {
    std::vector<std::string> commands;
    constexpr std::string_view start = "    edgewise ";
    for (const std::string& line : lines_of(text_of(page)))
        if (line.starts_with(start)) commands.push_back(line.substr(start.size()));
    return commands;
}

/// Every command of the page, in its order, as a shell runs it. A sweep takes fewer rounds.
TEST(EnginePage, IsFollowed) {
    if (!has_recorder("record_bullet") || !has_recorder("record_mujoco"))
        GTEST_SKIP() << "no engines here (Debian: libbullet-dev libmujoco-dev libmujoco-samples)";
    const Folder folder;
    std::string all;
    for (const std::string& command : commands_of(engine_page)) {
        const bool sweeps = command.starts_with("sweep");
        const std::string line =
            "$0 " + command +
            (sweeps ? " --queries 1000 --checked 50 --rounds 3 --layouts aos_f64,lean_f32" : "");
        const Outcome outcome = run_in_shell(line, {}, folder);
        EXPECT_EQ(outcome.exit_code, 0) << command << outcome.err;
        if (sweeps) {
            EXPECT_THAT(outcome.out, HasSubstr("4 cells: 4 verified, 0 failed, 0 unavailable"));
        }
        all += outcome.out;
    }
    EXPECT_THAT(all, AllOf(HasSubstr("stack.jsonl.gz: 120 steps"), HasSubstr("humanoids.jsonl.gz: 300 steps"),
                           HasSubstr("stack.lock.json: passed")));
    EXPECT_THAT(text_of(folder / "reports/out/report.md"), HasSubstr("stack"));
}

/// The commands that the page of commands gives to each kind of user. A sweep takes fewer rounds.
TEST(UsersPage, IsFollowed) {
    const std::filesystem::path page = std::filesystem::path(engine_page).parent_path() / "commands.md";
    const Folder folder;
    folder.write("my_link.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\n");
    std::string all;
    for (const std::string& command : commands_of(page)) {
        const bool sweeps = command.starts_with("sweep");
        const Outcome outcome = run_in_shell(
            "$0 " + command + (sweeps ? " --queries 500 --checked 50 --rounds 2 --no-report" : ""), {},
            folder);
        EXPECT_EQ(outcome.exit_code, 0) << command << outcome.err;
        if (sweeps) {
            EXPECT_THAT(outcome.out,
                        testing::ContainsRegex("^[1-9][0-9]* cells: .* 0 failed, 0 unavailable"));
        }
        all += outcome.out;
    }
    EXPECT_THAT(all, AllOf(HasSubstr("\"certificate\":{\"lower\":1.0,\"upper\":1.0}"),
                           HasSubstr("ways to 168 bytes per edge")));
    EXPECT_THAT(text_of(folder / "heat.svg"), HasSubstr("<svg"));
}

/// The header as the page shows it.
TEST(EnginePage, HasAProgramThatRecords) {
    const Folder folder;
    ASSERT_EQ(run_in_shell(std::string("exec ") + page_recorder, {}, folder).exit_code, 0);
    const Outcome outcome = run({"sweep", "--scenes", "mine.jsonl", "--layouts", "aos_f64", "--algorithms",
                                 "gjk", "--rounds", "2", "--no-report", "--json"},
                                folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["verified"], 1);
}

/// Two rounded boxes, which fall on a fixed one.
std::string falling(double speed) {
    std::ostringstream out;
    Recorder<double> recorder(out, "test", 1.0 / 60);
    recorder.add_box({1, 1, 1}, 0.05);
    for (std::size_t link = 0; link < 3; ++link)
        recorder.add_body({.shape = 0, .link = link, .fixed = link == 0});
    for (int i = 0; i < 60; ++i) {
        const double z = 2.2 - speed * i;
        const Recorder<double>::Pose poses[] = {
            {0, 0, 0, 1, 0, 0, 0}, {0.9, 0, z, 1, 0, 0, 0}, {-1.2, 0, z, 0.8, 0, 0, 0.6}};
        recorder.step({.time = i / 60.0, .poses = poses});
    }
    return out.str();
}

TEST(Recorded, IsMeasuredLikeAnyScene) {
    const Folder folder;
    folder.write("fall.jsonl", falling(0.004));
    folder.write("both.json",
                 R"({"scene": "recorded", "recording": "fall.jsonl", "vary": {"own_tables": [0, 1]}})");
    folder.write("plan.json",
                 R"({"scenes": [{"name": "fall.jsonl", "caches": ["all"]}, {"name": "both.json"},
        {"name": "tumble", "shapes": ["cube8"]}], "shapes": ["cube8"], "meshes": [],
        "layouts": ["aos_f64", "lean_f32", "points_soa_f32"],
        "queries": 200, "checked": 50, "rounds": 3, "stability": 0, "coherence": 100, "machines": ["zen5"]})");
    const Outcome outcome = run({"sweep", "--plan", "plan.json", "--json"}, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json summary = json::parse(outcome.out);
    EXPECT_EQ(summary["verified"], 4 * 5);
    EXPECT_EQ(summary["failed"], 0);
    EXPECT_EQ(summary["coherence_rows"], 4);
    EXPECT_THAT(
        outcome.err,
        HasSubstr("recording fall: the cores are asked, without the radii (to 0.05) of 3 of 3 bodies"));
    const auto store = folder / "reports/out/edgewise.db";
    EXPECT_EQ(
        rows_of(store,
                "select distinct json_extract(scene_parameters, '$.own_tables') || ' ' || value from cell "
                "join figure using (hash) where scene = 'both' and probe = 'memory' and name = 'tables' "
                "order by 1"),
        (std::vector<std::string>{"0.0 1.0", "1.0 3.0"}))
        << "one shape, three bodies";
    const auto figure = [&](const std::string& scene, const std::string& name) {
        return std::stod(rows_of(store,
                                 "select value from figure join cell using (hash) where run = 'coherence' "
                                 "and scene = '" +
                                     scene + "' and name = '" + name + "'")
                             .at(0));
    };
    EXPECT_NEAR(figure("fall", "way_median"), 0.004 / std::sqrt(12), 1e-9) << "over the extent";
    EXPECT_NEAR(figure("fall", "turn_p99"), 0, 1e-9);
    EXPECT_EQ(figure("fall", "persistent"), 1);
    EXPECT_NEAR(figure("tumble", "turn_p90"), 0.0165, 0.0035) << "two bodies, 0.01 rad each";
    EXPECT_THAT(text_of(folder / "reports/out/report.md"), HasSubstr("How coherent is the motion?"));
}

/// The boxes' cores meet below a height of 2, with their radii below 2.1.
TEST(Recorded, AsksRoundedBodiesBesideTheirCores) {
    const Folder folder;
    folder.write("fall.jsonl", falling(0.004));
    const auto sweep = [&](const std::string& scene) {
        return run({"sweep", "--scenes", scene, "--layouts", "aos_f64", "--queries", "200", "--checked",
                    "200", "--rounds", "2", "--axes", "radius=recorded", "--no-report", "--store", "own.db"},
                   folder)
            .out;
    };
    EXPECT_THAT(sweep("fall.jsonl"), HasSubstr("4 cells: 4 verified"));
    EXPECT_EQ(
        rows_of(folder / "own.db",
                "select distinct axes, value from cell join figure using (hash) where run = 'sweep' and "
                "name = 'separated' order by 1"),
        (std::vector<std::string>{"|100.0", "radius=recorded|52.0"}))
        << "50 and 26 steps of two pairs";
    folder.write("none.jsonl",
                 std::regex_replace(falling(0.004), std::regex("\"radius\":0.05"), "\"radius\":0"));
    EXPECT_THAT(sweep("none.jsonl"), HasSubstr("4 cells: 2 verified, 0 failed, 2 unavailable"));
}

TEST(Recorded, IsRacedByAdvise) {
    const Folder folder;
    folder.write("fall.jsonl", falling(0.004));
    const Outcome outcome = run({"advise", "--scene", "fall.jsonl", "--time", "600", "--json"}, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json advice = json::parse(outcome.out);
    EXPECT_EQ(advice["processes"], 3);
    EXPECT_THAT(advice["asked"]["scene"].dump(), HasSubstr("recorded"));
    EXPECT_FALSE(advice["take"].is_null());
}

TEST(Recorded, IsHeldByALock) {
    const Folder folder;
    folder.write("fall.jsonl", falling(0.004));
    ASSERT_EQ(run_in_shell("$0 lock --scene fall.jsonl --table lean_f32 --queries 100 > l.json", {}, folder)
                  .exit_code,
              0);
    const Outcome same = run({"lock", "--check", "l.json"}, folder);
    EXPECT_EQ(same.exit_code, 0) << same.out;
    folder.write("fall.jsonl", falling(0.006));
    const Outcome other = run({"lock", "--check", "l.json"}, folder);
    EXPECT_NE(other.exit_code, 0);
    EXPECT_THAT(other.out + other.err, HasSubstr("shape"));
}

TEST(Recorded, IsRefusedWithWhatToDo) {
    const Folder folder;
    folder.write("fall.jsonl", falling(0.004));
    folder.write("cut.jsonl", falling(0.004).substr(0, 2000));
    folder.write("slow.json",
                 R"({"scene": "recorded", "recording": "fall.jsonl", "parameters": {"rate": 10}})");
    const std::pair<Arguments, const char*> all[] = {
        {{"sweep", "--scenes", "cut.jsonl"}, "cut.jsonl:"},
        {{"sweep", "--scenes", "none.jsonl.gz"}, "none.jsonl.gz: no such file"},
        {{"sweep", "--scenes", "fall.jsonl", "--shape", "cube8"}, "name none with --shape"},
        {{"sweep", "--scenes", "recorded"}, "scene 'recorded' is of a file"},
        {{"advise", "--scene", "slow.json"}, "slow.json: for motion of an engine name the recording itself"},
        {{"bench", "scaling", "--scene", "fall.jsonl", "--shape", "cube8"}, "leave --shape out"},
        {{"draw", "heat", "--scene", "fall.jsonl", "--shape", "cube8"}, "leave --shape out"},
        {{"lock", "--scene", "fall.jsonl", "--shape", "cube8"}, "leave --shape out"},
        {{"fields", "--scene", "fall.jsonl"}, "edgewise sweep --scenes fall.jsonl measures it"},
        {{"bench", "effort", "--scene", "fall.jsonl"}, "edgewise sweep --scenes fall.jsonl measures it"},
        {{"record", "bullet-stak", "--out", "a.jsonl"}, "did you mean 'bullet-stack'?"},
        {{"record", "bullet-stack", "--seconds", "0", "--out", "a.jsonl"}, "0.01"}};
    for (const auto& [arguments, said] : all) {
        const Outcome outcome = run(arguments, folder);
        EXPECT_EQ(outcome.exit_code, 2) << said << outcome.out;
        ASSERT_FALSE(outcome.err.empty());
        EXPECT_THAT(lines_of(outcome.err).back(), HasSubstr(said));
    }
}

/// A build without an engine has no recorder: a program in a folder of its own.
TEST(Recorded, NamesThePackageOfAMissingEngine) {
    const Folder folder;
    std::filesystem::copy(program_path, folder / "edgewise");
    const std::pair<const char*, const char*> all[] = {
        {"bullet-wall", "Debian: libbullet-dev"},
        {"humanoid.xml", "Debian: libmujoco-dev libmujoco-samples"},
        {"arm.sdf", "Debian: libsdformat-dev"}};
    for (const auto& [model, package] : all) {
        const Outcome outcome =
            run_in_shell(std::string("./edgewise record ") + model + " --out a.jsonl", {}, folder);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err, HasSubstr(package));
    }
}

/// Distances between cores, less the radii, are MuJoCo's own: frames and radii are those that it asks with.
TEST(Recorded, ByMujocoHasItsFrames) {
    if (!has_recorder("record_mujoco")) GTEST_SKIP() << "no MuJoCo here (Debian: libmujoco-dev)";
    const Folder folder;
    folder.write("two.xml", R"(<mujoco><option gravity="0 0 0"/><worldbody>
        <body pos="0 0 0"><freejoint/><geom type="sphere" size="0.5" pos="0 0 0.1" margin="1"/></body>
        <body pos="1.2 0 0" euler="0 90 0"><freejoint/><geom type="capsule" size="0.25 0.5" pos="0.3 0 0" margin="1"/></body>
        <geom type="box" size="2 2 0.1" pos="0 0 -1" margin="1"/><geom type="plane" size="9 9 1" pos="0 0 -5"/>
        </worldbody></mujoco>)");
    ASSERT_EQ(run({"record", "two.xml", "--seconds", "0.01", "--out", "two.jsonl"}, folder).exit_code, 0);
    const auto lines = lines_of(text_of(folder / "two.jsonl"));
    const json header = json::parse(lines.at(0)), step = json::parse(lines.at(1));
    EXPECT_EQ(header["bodies"].size(), 4U);
    EXPECT_EQ(header["bodies"][0]["fixed"], true);
    ASSERT_GT(step["contacts"].size(), 1U);
    double nearest = 9;
    for (const json& contact : step["contacts"])
        if (contact[0] > 1 && contact[1] > 1) nearest = std::min(nearest, contact[2].get<double>());
    // The capsule's axis lies along x from 0.7 to 1.7 at z = -0.3; the sphere's centre is at z = 0.1.
    EXPECT_NEAR(nearest, std::sqrt(0.7 * 0.7 + 0.4 * 0.4) - 0.75, 1e-6);
    const Outcome asked = run({"sweep", "--scenes", "two.jsonl", "--layouts", "aos_f64", "--algorithms",
                               "gjk", "--rounds", "2", "--store", "s.db", "--no-report"},
                              folder);
    EXPECT_EQ(asked.exit_code, 0) << asked.err;
}

TEST(Recorded, ACylinderOfMujocoIsAPrismAroundIt) {
    if (!has_recorder("record_mujoco")) GTEST_SKIP() << "no MuJoCo here (Debian: libmujoco-dev)";
    const Folder folder;
    folder.write("can.xml",
                 R"(<mujoco><worldbody><geom type="cylinder" size="0.5 0.75"/></worldbody></mujoco>)");
    const Outcome outcome = run({"record", "can.xml", "--seconds", "0.01", "--out", "can.jsonl"}, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("cylinders (1) are recorded as prisms of 32 sides around them"));
    EXPECT_EQ(lines_of(outcome.err).size(), 1U);
    EXPECT_THAT(outcome.err, Not(HasSubstr("?"))) << "a line end that is shown";
    const json vertices = json::parse(lines_of(text_of(folder / "can.jsonl")).at(0))["shapes"][0]["vertices"];
    ASSERT_EQ(vertices.size(), 64U);
    double nearest_side = 9;
    for (std::size_t i = 0; i < vertices.size(); i += 2) {
        EXPECT_EQ(vertices[i][2], 0.75);
        EXPECT_EQ(vertices[i + 1][2], -0.75);
        const json &from = vertices[i], &to = vertices[(i + 2) % vertices.size()];
        const double x = (from[0].get<double>() + to[0].get<double>()) / 2,
                     y = (from[1].get<double>() + to[1].get<double>()) / 2;
        nearest_side = std::min(nearest_side, std::hypot(x, y));
    }
    EXPECT_NEAR(nearest_side, 0.5, 1e-12) << "sides touch the cylinder";
}

}  // namespace
}  // namespace edgewise::cli_test
