// SPDX-License-Identifier: MIT
//
// `edgewise sweep`, `edgewise report` and `edgewise report claims` on plans of a second: what they print,
// leave behind and end with.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli_paths.hpp"
#include "program.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const char* const usual_store = "reports/out/edgewise.db";

const Arguments tiny = {"sweep",     "--scenes", "tumble",    "--shapes", "cube8",    "--layouts", "aos",
                        "--queries", "200",      "--checked", "20",       "--rounds", "3",         "--json"};

/// A sweep of two bodies reproduces little; that is a finding, not an error.
void expect_claims(const Folder& folder) {
    const Outcome outcome = run({"report", "claims", usual_store, "--json"}, folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json all = json::parse(outcome.out);
    EXPECT_TRUE(all["machine"].is_object());
    EXPECT_GT(all["claims"].size(), 25u);
    for (const json& claim : all["claims"]) {
        for (const char* key : {"id", "kind", "section", "claim", "paper", "ours", "unit", "verdict",
                                "reason", "rule", "conditions"})
            EXPECT_TRUE(claim[key].is_string()) << key;
        EXPECT_TRUE(claim["deterministic"].is_boolean());
    }
    const Outcome table = run({"report", "claims", usual_store}, folder);
    EXPECT_EQ(table.exit_code, 0) << table.err;
    EXPECT_THAT(lines_of(table.out).at(0), HasSubstr(" not measured")) << "the summary first";
    EXPECT_THAT(lines_of(table.out).at(1), HasSubstr("layouts/sweep --paper")) << "then the remedy";
    EXPECT_THAT(table.out, HasSubstr("bytes_per_edge_double"));
}

/// Nothing is measured twice, and all that is said can be written again from the store.
TEST(Sweep, MeasuresEveryCellAndSaysSoInJson) {
    const Folder folder;
    const Outcome outcome = run(tiny, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(lines_of(outcome.out).size(), 1u);
    const json summary = json::parse(outcome.out);
    // quick has tumble twice; aos has three precisions; both algorithms walk it
    EXPECT_EQ(summary["cells"], 2 * 3 * 2);
    EXPECT_EQ(summary["verified"], summary["cells"]);
    EXPECT_EQ(summary["failed"], 0);
    EXPECT_EQ(summary["unavailable"], 0);
    EXPECT_EQ(summary["store"], usual_store);
    EXPECT_EQ(summary["report"], "reports/out/index.html");
    const auto rounds = rounds_in(folder / usual_store);
    EXPECT_EQ(rounds.size(), 12u * 3);
    for (const char* page :
         {"reports/out/index.html", "reports/out/report.md", "reports/out/results/tumble.csv"}) {
        EXPECT_GT(text_of(folder / page).size(), 500u) << page;
    }
    EXPECT_EQ(run(tiny, folder).out, outcome.out);
    EXPECT_EQ(rounds_in(folder / usual_store), rounds);
    json of_report = json::parse(run({"report", usual_store, "--out", "again", "--json"}, folder).out);
    EXPECT_EQ(of_report["report"], "again/index.html");
    EXPECT_GT(text_of(folder / "again/index.html").size(), 500u);
    of_report["report"] = summary["report"];
    EXPECT_EQ(of_report, summary);
    expect_claims(folder);
}

/// Plan quick asks GJK on aos elsewhere, in no scene of pressure.
TEST(Sweep, NamedLayoutsAreAskedInScenesThatThePlanRestricts) {
    const Folder folder;
    const Outcome outcome =
        run({"sweep", "--scenes", "pressure", "--shapes", "tetra4", "--layouts", "aos_f64", "--queries",
             "100", "--checked", "5", "--rounds", "2", "--no-report", "--json"},
            folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["cells"], 2 * 2) << "two numbers of bodies, two algorithms";
}

TEST(Sweep, TakesFurtherAxesOneAtATimeBesideThePlainCells) {
    const Folder folder;
    const Outcome outcome = run(
        with(tiny, {"--axes", "contact_tolerance=0.01,gap_tolerance=0.001,sub_distance=johnson,radius=0.1",
                    "needs=nearer,needs=within+margin=1"}),
        folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json summary = json::parse(outcome.out);
    EXPECT_EQ(summary["verified"], summary["cells"]);
    // The gap and the solver are GJK's alone: five cells for V-Clip's three.
    EXPECT_EQ(rows_of(folder / usual_store, "select 1 from cell where axes not like '%needs=%'").size(),
              2U * 3 * (3 + 5));
    const std::string csv = text_of(folder / "reports/out/results/tumble.csv");
    for (const char* words : {"aos_f32 gap_tolerance=0.001", "aos_f64 sub_distance=johnson", "told_by_bounds",
                              "needs=nearer+margin=0.1", "aos_f64 needs=within+margin=1"})
        EXPECT_THAT(csv, HasSubstr(words));
    const Outcome unknown = run(with(tiny, {"--axes", "colour=red"}), folder);
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("axis 'colour=red': unknown; known: contact_tolerance=LENGTH"));
    const Outcome bench =
        run({"bench", "model", "--needs", "nearer", "--queries", "100", "--repetitions", "1"}, folder);
    EXPECT_EQ(bench.exit_code, 0) << bench.err;
}

/// The same queries by the same source, compiled with other flags: the same worst error, to the bit.
TEST(Sweep, DefaultFlagsGiveTheErrorsOfTheTool) {
    const Folder folder;
    const Outcome outcome = run(
        {"sweep", "--scenes", "cold,tumble,pressure", "--shapes", "cube8", "--queries", "300", "--checked",
         "50", "--rounds", "3", "--axes", "build=default", "--no-report", "--store", "own.db"},
        folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto pairs = rows_of(
        folder / "own.db",
        "select a.scene, a.algorithm, a.table_type, e.value = f.value from cell a join cell b using "
        "(build, scene, scene_parameters, shape, algorithm, table_type) join figure e on e.hash = a.hash "
        "join figure f on f.hash = b.hash where a.axes = '' and b.axes = 'build=default' and "
        "b.status = 'verified' and e.name = 'worst_error_given' and f.name = e.name");
    EXPECT_GE(pairs.size(), 4U * 5) << "at least V-Clip on aos and lean, GJK on points_soa, in five scenes";
    for (const std::string& pair : pairs) EXPECT_TRUE(pair.ends_with("|1")) << pair;
}

/// What is near the fastest is timed by every process; a second run has nothing to do.
TEST(Sweep, FurtherProcessesTimeTheFinalistsAgain) {
    const Folder folder;
    const Arguments three = with(tiny, {"--processes", "3", "--layouts", "lean"});
    const Outcome outcome = run(three, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("process 3 of 3 times the fastest cells again"));
    const auto cells_of = [&](const std::string& of) {
        return rows_of(folder / usual_store,
                       "select scene_parameters, algorithm, table_type, axes from cell where run = '" + of +
                           "' order by 1, 2, 3, 4");
    };
    const auto finalists = cells_of("process 2");
    EXPECT_GE(finalists.size(), 2U) << "the fastest of two scenes; the baseline is of another layout";
    EXPECT_EQ(cells_of("process 3"), finalists);
    EXPECT_LE(finalists.size(), cells_of("sweep").size());
    EXPECT_THAT(text_of(folder / "reports/out/report.md"), HasSubstr("hold between processes"));
    ASSERT_EQ(run(three, folder).exit_code, 0);
    EXPECT_EQ(cells_of("process 2"), finalists);
}

/// Times that were measured beside others stay so, whatever is run later: the reader finds the share by
/// scene.
TEST(Sweep, KeepsTheShareThatOthersTookWithTheTimes) {
    const Folder folder;
    const Arguments contest = with(tiny, {"--layouts", "lean,points_soa"});
    ASSERT_EQ(run(contest, folder).exit_code, 0);
    const auto store = folder / usual_store;
    change(store,
           "insert or replace into meta select distinct 'others ' || build || ' ' || scene || ' ' || "
           "scene_parameters || ' ' || shape, '0.99' from cell");
    ASSERT_EQ(run(contest, folder).exit_code, 0);
    EXPECT_THAT(text_of(folder / "reports/out/report.md"), HasSubstr("others took 99 % of the processor"));
    Arguments further = contest;
    std::ranges::replace(further, "3", "4");
    ASSERT_EQ(run(further, folder).exit_code, 0) << "a fourth round is timed";
    EXPECT_EQ(rows_of(store, "select distinct value from meta where key like 'others %'"),
              std::vector<std::string>{"0.99"});
}

TEST(Sweep, TakesAPlanFromAFile) {
    const Folder folder;
    const json plan = {
        {"scenes", {{{"name", "tumble"}, {"parameters", {{"rotation_step", 0.5}}}}, {{"name", "cold"}}}},
        {"shapes", {"tetra4"}},
        {"meshes", json::array()},
        {"layouts", {"aos_f64"}},
        {"algorithms", {"gjk"}},
        {"queries", 100},
        {"checked", 10},
        {"rounds", 2},
        {"stability", 0}};
    folder.write("mine.json", plan.dump());
    const Outcome outcome =
        run({"sweep", "--plan", "mine.json", "--store", "a/b.db", "--out", "pages", "--json"}, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json summary = json::parse(outcome.out);
    EXPECT_EQ(summary["cells"], 2);
    EXPECT_EQ(summary["verified"], 2);
    EXPECT_EQ(summary["report"], "pages/index.html");
    const auto scenes =
        rows_of(folder / "a/b.db", "select scene, scene_parameters from cell order by scene desc");
    ASSERT_EQ(scenes.size(), 2u);
    EXPECT_THAT(scenes[0], HasSubstr("0.5"));
}

/// That program lies in a folder with no meshes near it, so the plan's real bodies are missing.
TEST(Sweep, ShowsABodyThatCannotBeHadAsUnavailable) {
    const Folder folder;
    folder.write("plan.json", R"({"shapes": ["tetra4"], "scenes": [{"name": "cold"}],
        "layouts": ["straight"], "queries": 100, "checked": 10, "rounds": 2, "stability": 0})");
    const Outcome outcome =
        Process(crooked_program_path, {"sweep", "--plan", "plan.json", "--json"}, folder).wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("atlas_foot.stl"));
    const json summary = json::parse(outcome.out);
    EXPECT_EQ(summary["cells"], 5);
    EXPECT_EQ(summary["verified"], 1);
    EXPECT_EQ(summary["unavailable"], 4);
    const auto reasons = rows_of(folder / usual_store, "select reason from cell where reason <> ''");
    EXPECT_EQ(reasons.size(), 4u);
    EXPECT_THAT(reasons, testing::Each(HasSubstr(".stl")));
}

/// That program has none of the manifest's layouts.
TEST(Sweep, SaysHowToCompileALayoutThatTheProgramLacks) {
    for (const char* name : {"ring", "ring_f64"}) {
        const Folder folder;
        const Outcome outcome =
            Process(crooked_program_path, {"sweep", "--scenes", "cold", "--layouts", name}, folder).wait();
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err, HasSubstr(std::string("'") + name + "' is not in this program: "));
        EXPECT_THAT(outcome.err, HasSubstr("EDGEWISE_EVERY_LAYOUT=ON"));
    }
}

/// The program with a wrong layout (crooked.hpp) and a right one linked in: the wrong one's cell fails
/// with its reason, is not timed, and the sweep goes on.
TEST(Sweep, RecordsAFailingCellAndGoesOn) {
    const Folder folder;
    const Arguments arguments = {"sweep", "--scenes",  "cold", "--shapes", "cube8", "--queries",
                                 "300",   "--checked", "50",   "--rounds", "3",     "--json"};
    const Outcome outcome = Process(crooked_program_path, arguments, folder).wait();
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("crooked_f64"));
    EXPECT_THAT(outcome.err, testing::Not(HasSubstr(".stl"))) << "no word on bodies that it does not use";
    const json summary = json::parse(outcome.out);
    EXPECT_EQ(summary["cells"], 2);
    EXPECT_EQ(summary["failed"], 1);
    EXPECT_EQ(summary["verified"], 1);
    const auto rows = rows_of(folder / usual_store,
                              "select table_type, status, reason <> '', (select count(*) from round where "
                              "round.hash = cell.hash) from cell order by table_type");
    EXPECT_THAT(rows, testing::ElementsAre("crooked_f64|failed|1|0", "straight_f64|verified|0|3"));
    EXPECT_THAT(text_of(folder / "reports/out/report.md"), HasSubstr("crooked"));
}

}  // namespace
}  // namespace edgewise::cli_test
