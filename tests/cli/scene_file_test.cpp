// SPDX-License-Identifier: MIT
//
// Scenes from files through the command line: a user's own file, its cells, its place in the report, whatever
// its name is.
#include <gmock/gmock.h>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "program.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* mine = R"({"scene": "tumble", "shapes": ["cube8"], "time_step": 0.5, "queries": 300,
    "sharing": "per_instance", "parameters": {"bodies": 20, "in_time_order": 1},
    "vary": {"angular_velocity": [0.5, 2, "random"]}, "note": "three speeds"})";

Outcome sweep(const Folder& folder, const std::string& layouts) {
    return run({"sweep", "--scenes", "mine.json", "--layouts", layouts, "--checked", "20", "--rounds", "5",
                "--json"},
               folder);
}

TEST(SceneFiles, AreMeasuredPointByPoint) {
    const Folder folder;
    folder.write("mine.json", mine);
    const Outcome outcome = sweep(folder, "aos_f64,lean_f64");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json summary = json::parse(outcome.out);
    EXPECT_EQ(summary["cells"], 3 * 2 * 2);
    EXPECT_EQ(summary["verified"], summary["cells"]);
    const auto store = folder / "reports/out/edgewise.db";
    EXPECT_EQ(rows_of(store, "select distinct scene from cell"), std::vector<std::string>{"mine"});
    const auto steps = rows_of(store,
                               "select distinct json_extract(scene_parameters, '$.rotation_step') from cell "
                               "order by 1");
    EXPECT_EQ(steps.size(), 3U) << "0.25, 1, and 0 for the random turns";
    EXPECT_EQ(rows_of(store, "select count(*) from meta where key = 'scene mine'").size(), 1U);
    EXPECT_EQ(
        rows_of(store, "select value from figure where probe = 'memory' and name = 'tables' and value <> 20")
            .size(),
        0U)
        << "a table for each body";
    EXPECT_THAT(text_of(folder / "reports/out/index.html"), HasSubstr("Your own scenes"));
    EXPECT_THAT(text_of(folder / "reports/out/results/mine.csv"), HasSubstr(",mine,"));
    const Outcome again = sweep(folder, "aos_f64,lean_f64");
    EXPECT_EQ(again.out, outcome.out) << "nothing is measured twice";
}

constexpr const char* corner = "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::vector<std::string> shapes_in(const Folder& folder) {
    return rows_of(folder / "reports/out/edgewise.db",
                   "select distinct shape || ' ' || vertices || ' ' || shape_source from cell order by 1");
}

/// A mesh is found from where the scene file lies, and is called after its file.
TEST(SceneFiles, TakeMeshesForShapes) {
    const Folder folder;
    std::filesystem::create_directory(folder / "scenes");
    folder.write("scenes/my_link.obj", corner);
    folder.write("scenes/mine.json",
                 R"({"scene": "tumble", "shapes": ["my_link.obj", "cube8"], "queries": 200})");
    const Outcome outcome = run(
        {"sweep", "--scenes", "scenes/mine.json", "--layouts", "aos_f64", "--checked", "20", "--rounds", "3"},
        folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(shapes_in(folder),
              (std::vector<std::string>{"cube8 8 built-in", "my_link 4 my_link.obj, scaled by 4/3"}));
}

/// Bodies that are named on the command line replace a file's, which once were measured in their place in
/// silence.
TEST(SceneFiles, TakeTheBodiesOfTheCommandLine) {
    const Folder folder;
    folder.write("corner.obj", corner);
    folder.write("mine.json", mine);
    const Outcome outcome = run({"sweep", "--scenes", "mine.json", "--layouts", "aos_f64", "--checked", "20",
                                 "--rounds", "3", "--mesh", "corner.obj"},
                                folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(shapes_in(folder), std::vector<std::string>{"corner 4 corner.obj, scaled by 4/3"});
    folder.write("lost.json", R"({"scene": "tumble", "shapes": ["lost.obj"]})");
    const Outcome lost = run({"sweep", "--scenes", "lost.json"}, folder);
    EXPECT_EQ(lost.exit_code, 2);
    EXPECT_THAT(lost.err, HasSubstr("lost.obj"));
}

TEST(SceneFiles, OfThePaperAreListed) {
    const Folder folder;
    const Outcome outcome = run({"list", "scene_files", "--json"}, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json files = json::parse(outcome.out)["scene_files"];
    EXPECT_GE(files.size(), 15U);
    EXPECT_EQ(files[0]["name"], "paper_static");
    EXPECT_EQ(files[0]["file"]["scene"], "static") << "the file itself, to start one's own from";
}

constexpr const char* small_scene = R"({"scene": "tumble", "shapes": ["cube8"], "queries": 60,
    "parameters": {"bodies": 6}})";

Outcome sweep_files(const Folder& folder, const std::vector<std::string>& files) {
    return run(
        with({"sweep", "--layouts", "aos_f64", "--checked", "10", "--rounds", "2", "--json", "--scenes"},
             files),
        folder);
}

TEST(SceneFileNames, OfTwoFilesInTwoRunsAreRefusedNamingBoth) {
    const Folder folder;
    std::filesystem::create_directory(folder / "c1");
    std::filesystem::create_directory(folder / "c2");
    folder.write("c1/s.json", small_scene);
    folder.write("c2/s.json", R"({"scene": "cold", "shapes": ["cube8"], "queries": 60})");
    ASSERT_EQ(sweep_files(folder, {"c1/s.json"}).exit_code, 0);
    ASSERT_EQ(sweep_files(folder, {"c1/s.json"}).exit_code, 0) << "the same again";
    const Outcome other = sweep_files(folder, {"c2/s.json"});
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_THAT(other.err, AllOf(HasSubstr("c1/s.json"), HasSubstr("c2/s.json")));
    EXPECT_EQ(lines_of(other.err).size(), 1U) << other.err;
    EXPECT_EQ(rows_of(folder / "reports/out/edgewise.db", "select count(*) from cell"),
              std::vector<std::string>{"2"});
}

TEST(SceneFileNames, ThatAreNoUtf8OrActAreShownAsNumbers) {
    const Folder folder;
    const std::vector<std::string> names = {"lat\xff", "esc\x1b[31m", "turn\xe2\x80\xae"};
    std::vector<std::string> files;
    for (const std::string& name : names) files.push_back(folder.write(name + ".json", small_scene));
    const Outcome swept = sweep_files(folder, files);
    ASSERT_EQ(swept.exit_code, 0) << swept.err;
    std::filesystem::copy(folder / "reports/out/edgewise.db", folder / "other\xff.db");
    const std::string store = "reports/out/edgewise.db", other = "other\xff.db";
    for (const Arguments& arguments : {Arguments{"export", store},
                                       {"export", store, "--json"},
                                       {"report", other, "--compare", store, "--json", "--out", "p1"},
                                       {"report", other, "--compare", store, "--out", "p2"},
                                       {"merge", store, other, "--out", "all.db", "--json"}}) {
        const Outcome outcome = run(arguments, folder);
        EXPECT_EQ(outcome.exit_code, 0) << arguments[0] << outcome.err;
        for (const char* raw : {"\xff", "\x1b", "\xe2\x80\xae"})
            EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr(raw))) << arguments[0];
        if (arguments.back() != "--json") continue;
        EXPECT_TRUE(json::accept(outcome.out)) << outcome.out;
    }
    const Outcome query = run({"query", "bad\xff.json", "--json"}, folder);
    EXPECT_EQ(query.exit_code, 2);
    EXPECT_THAT(query.err, AllOf(HasSubstr("bad\\xFF.json"), Not(HasSubstr("json.exception"))));
}

}  // namespace
}  // namespace edgewise::cli_test
