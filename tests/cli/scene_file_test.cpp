// SPDX-License-Identifier: MIT
//
// Scenes from files through the command line: a user's own file, its cells, its place in the report; mistakes
// answered with one line before anything is measured.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "program.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

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

/// Steps and answers of the same seed are the same figures, whatever the clock says.
TEST(SceneFiles, GiveTheSameDeterministicFigures) {
    const std::string sql =
        "select hash, probe, name, value from figure where probe in ('error', 'work', 'bytes') or name in "
        "('pairs_per_step', 'box_tests_per_step', 'moves_per_step') order by 1, 2, 3";
    std::vector<std::string> figures[2];
    for (auto& found : figures) {
        const Folder folder;
        folder.write("mine.json", mine);
        ASSERT_EQ(sweep(folder, "aos_f64").exit_code, 0);
        found = rows_of(folder / "reports/out/edgewise.db", sql);
    }
    EXPECT_GT(figures[0].size(), 100U);
    EXPECT_EQ(figures[0], figures[1]);
}

TEST(SceneFiles, WithMistakesAreRefusedInOneLine) {
    const Folder folder;
    folder.write("mine.json", R"({"scene": "tumble", "shapes": ["cube8"], "parameters": {"bodies": 1}})");
    const Outcome bad = sweep(folder, "aos_f64");
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_THAT(bad.err,
                HasSubstr("scene file mine: scene 'tumble': bodies = 1 is out of bounds; choose 2 to"));
    EXPECT_EQ(lines_of(bad.err).size(), 1U);
    const Outcome unknown = run({"sweep", "--scenes", "papr_static"}, folder);
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("paper_static"));
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

}  // namespace
}  // namespace edgewise::cli_test
