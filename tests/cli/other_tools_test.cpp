// SPDX-License-Identifier: MIT
//
// What other tools read. CI: a lock with limits, the formats of comparisons, and the composite action, whose
// script runs here as a runner would run it. callgrind_annotate: a profile of data.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "cli_paths.hpp"
#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A file of the project, by its path from the folder of the docs.
std::string project_text(const std::string& path) {
    return text_of(std::filesystem::path(options_file).parent_path() / path);
}
constexpr const char* ci_action = "../packaging/action/action.yml";

const Arguments small_lock = {"lock", "--table", "lean_f32", "--shape", "cube8", "--queries", "50"};

/// Writes the small lock, with this much taken off its bytes, as lean.lock.json.
void write_lock(const Folder& folder, double bytes_less, const Arguments& more = {}) {
    const Outcome outcome = run(with(small_lock, more), folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    json lock = json::parse(outcome.out);
    lock["figures"]["bytes"] = lock["figures"]["bytes"].get<double>() - bytes_less;
    folder.write("lean.lock.json", lock.dump());
}

int exit_code_of_check(double bytes_less, const Arguments& more) {
    const Folder folder;
    write_lock(folder, bytes_less, more);
    return run({"lock", "--check", "lean.lock.json"}, folder).exit_code;
}

TEST(CiFormats, ALockHasSoftAndHardLimits) {
    EXPECT_EQ(exit_code_of_check(8, {"--limit", "bytes=50%"}), 0);
    EXPECT_EQ(exit_code_of_check(8, {"--limit", "bytes=0.01%"}), 1);
    EXPECT_EQ(exit_code_of_check(8, {"--limit", "b*=50%", "--limit", "bytes=16"}), 3);
}

TEST(CiFormats, AreOfLocksAndOfComparedRecords) {
    const Folder folder;
    write_lock(folder, 8);
    const Outcome check = run({"lock", "--check", "lean.lock.json", "--format", "markdown"}, folder);
    EXPECT_EQ(check.exit_code, 1);
    EXPECT_THAT(check.out, HasSubstr("| regressions of exact figures |"));
    const json figures =
        json::parse(run({"lock", "--check", "lean.lock.json", "--format", "github"}, folder).out);
    EXPECT_EQ(figures[0]["name"], "lean: bytes");
    const json cells =
        json::parse(run({"compare", "lean.lock.json", "lean.lock.json", "--format", "bencher"}, folder).out);
    EXPECT_TRUE(cells["lean"]["lines_per_query.cold"]["value"].is_number());
    EXPECT_THAT(run({"compare", "lean.lock.json", "lean.lock.json", "--format", "junit"}, folder).out,
                HasSubstr("failures=\"0\""));
    EXPECT_THAT(run({"compare", "lean.lock.json", "lean.lock.json", "--slack", "0.2"}, folder).err,
                HasSubstr("--slack is of times, and lean.lock.json has none: leave it out"));
    EXPECT_EQ(
        run({"compare", records_folder + std::string("/zen3.json"), "--format", "junit"}, folder).exit_code,
        2);
}

/// The script of the action's only step, which is the last member of the file.
std::string script_of_action() {
    const std::string action = project_text(ci_action);
    const std::size_t run = action.find("      run: |\n");
    std::string script;
    for (const std::string& line : lines_of(action.substr(run + 13)))
        script += line.substr(std::min<std::size_t>(line.size(), 8)) + "\n";
    return script;
}

struct ActionRun {
    Outcome outcome;
    std::string summary, figures;
};

ActionRun run_action(const std::string& environment, const Folder& folder) {
    folder.write("summary.md", "# Job\n");
    folder.write("step.sh", script_of_action());
    const std::string command =
        "export EDGEWISE=\"$0\" GITHUB_STEP_SUMMARY=summary.md FORMAT=github FIGURES= NEW= " + environment +
        "; bash -e step.sh";
    ActionRun ran{run_in_shell(command, {}, folder), text_of(folder / "summary.md"), ""};
    if (std::filesystem::exists(folder / "figures.json")) ran.figures = text_of(folder / "figures.json");
    return ran;
}

TEST(CiAction, RunsAsOnARunner) {
    const Folder folder;
    write_lock(folder, 0);
    ActionRun ran = run_action("OLD=lean.lock.json FIGURES=figures.json", folder);
    EXPECT_EQ(ran.outcome.exit_code, 0) << ran.outcome.err;
    EXPECT_THAT(ran.summary, testing::StartsWith("# Job\nlean.lock.json: passed; "));
    EXPECT_GT(json::parse(ran.figures).size(), 10U);
    write_lock(folder, 8, {"--limit", "bytes=16"});
    ran = run_action("OLD=lean.lock.json FIGURES=figures.json FORMAT=bencher", folder);
    EXPECT_EQ(ran.outcome.exit_code, 3);
    EXPECT_THAT(ran.summary, HasSubstr("| regressions of exact figures |"));
    EXPECT_TRUE(json::parse(ran.figures).contains("lean"));
    EXPECT_EQ(run_action("OLD=lean.lock.json NEW=lean.lock.json", folder).outcome.exit_code, 3)
        << "a figure that was over its limit still is";
    EXPECT_EQ(run_action("OLD=none.json", folder).outcome.exit_code, 2);
}

/// The workflow in the docs names the action's inputs, and gives those that it needs.
TEST(CiAction, HasTheInputsOfTheDocs) {
    const std::string docs = project_text("hold_a_layout.md"), action = project_text(ci_action);
    const std::size_t uses = docs.find("uses: ./packaging/action\n");
    ASSERT_NE(uses, std::string::npos);
    const std::string workflow = docs.substr(uses, docs.find("\n\n", uses) - uses);
    EXPECT_THAT(workflow, HasSubstr(" old: "));
    const std::regex member(" {8,}([a-z]+): ");
    std::size_t inputs = 0;
    for (std::sregex_iterator at(workflow.begin(), workflow.end(), member), end; at != end; ++at, ++inputs)
        EXPECT_THAT(action, HasSubstr("\n  " + (*at)[1].str() + ":\n"));
    EXPECT_GE(inputs, 2U);
}

constexpr const char* one_cell =
    R"({"scenes": [{"name": "tumble"}], "shapes": ["cube8"], "meshes": [], "layouts": ["lean_f32", "aos_f64"],
    "algorithms": ["vclip"], "axes": [], "machines": [], "queries": 100, "checked": 20, "rounds": 1, "stability": 0})";

void write_store(const Folder& folder) {
    folder.write("plan.json", one_cell);
    const Outcome outcome = run({"sweep", "--plan", "plan.json", "--store", "s.db", "--no-report"}, folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
}

/// Numbers of the line that begins with this word.
std::vector<double> numbers_after(const std::string& text, const std::string& word) {
    std::istringstream words(text.substr(text.find("\n" + word + " ") + word.size() + 2));
    std::vector<double> numbers;
    for (double number = 0; words >> number;) numbers.push_back(number);
    return numbers;
}

/// The sums are those of the lock of the same cell.
TEST(Callgrind, HasTheCostsOfALockByComponentStepAndField) {
    const Folder folder;
    write_store(folder);
    const Arguments exported = {"export",   "s.db",      "--layouts",  "lean_f32",
                                "--format", "callgrind", "--machines", "zen5"};
    const Outcome profile = run(exported, folder);
    ASSERT_EQ(profile.exit_code, 0) << profile.err;
    EXPECT_THAT(profile.out, HasSubstr("\nevents: Reads Writes Lines zen5_L1D zen5_L2 zen5_L3\n"));
    EXPECT_THAT(profile.out, HasSubstr("\nfl=vertex_coordinates\nfn=vertex_vertex\n1 "));
    EXPECT_THAT(profile.out, HasSubstr("\nfl=pair\nfn=pair_cache\n"));
    const json lock = json::parse(
        run({"lock", "--table", "lean_f32", "--shape", "cube8", "--queries", "100", "--machines", "zen5"},
            folder)
            .out)["figures"];
    const double queries = lock["queries"].get<double>();
    const std::vector<double> totals = numbers_after(profile.out, "totals:");
    ASSERT_EQ(totals.size(), 6U);
    EXPECT_GT(totals[0], totals[2]);
    EXPECT_NEAR(totals[2], lock["lines_per_query"].get<double>() * queries, 1e-6);
    EXPECT_NEAR(totals[3], lock["misses_per_query.zen5.L1D"].get<double>() * queries, 1e-6);
    for (const Arguments& slip : {Arguments{"export", "s.db", "--machines", "zen5"},
                                  Arguments{"export", "s.db", "--scenes", "cold", "--format", "callgrind"}})
        EXPECT_EQ(run(slip, folder).exit_code, 2);
}

TEST(Callgrind, IsAnnotatedWithTheNamesOfFields) {
    const Folder folder;
    write_store(folder);
    if (run_in_shell("command -v callgrind_annotate", {}, folder).exit_code != 0)
        GTEST_SKIP() << "no callgrind_annotate here (Debian: valgrind)";
    const Outcome written =
        run({"export", "s.db", "--format", "callgrind", "--out", "all.callgrind"}, folder);
    ASSERT_EQ(written.exit_code, 0) << written.err;
    const Outcome annotated = run_in_shell(
        "callgrind_annotate --include=all.callgrind.fields --threshold=100 all.callgrind", {}, folder);
    ASSERT_EQ(annotated.exit_code, 0) << annotated.err;
    EXPECT_THAT(annotated.out, HasSubstr("voronoi_planes:vertex_"));
    EXPECT_THAT(annotated.out, HasSubstr("[aos_f64 vclip tumble"));
    EXPECT_TRUE(std::regex_search(annotated.out, std::regex("[0-9.]+%\\) .* voronoi_plane\n")));
}

}  // namespace
}  // namespace edgewise::cli_test
