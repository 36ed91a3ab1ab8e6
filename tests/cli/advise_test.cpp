// SPDX-License-Identifier: MIT
//
// `edgewise advise`: its JSON, its exit codes, and that it says what it left out. How long anything takes is
// not asked: a generous --time is never used up, and under a short one only what is said of gaps is looked
// at.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli_paths.hpp"
#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const Arguments enough_time = {"--time", "600"};

Arguments few_cubes(const Arguments& more) {
    return with(with({"advise", "--shape", "cube8", "--bodies", "3", "--json"}, more), enough_time);
}

bool is_named(const json& cells, const json& cell) {
    return std::ranges::any_of(cells, [&](const json& other) {
        return other["algorithm"] == cell["algorithm"] && other["table"] == cell["table"];
    });
}

/// Predictions are made where latencies were measured, on machines that say how large their caches are.
void expect_raced(const json& one, double error_limit, bool has_latencies) {
    ASSERT_EQ(one["time_ratio"].size(), 3U) << one;
    EXPECT_LE(one["time_ratio"][0], one["time_ratio"][1]);
    EXPECT_LE(one["time_ratio"][1], one["time_ratio"][2]);
    EXPECT_LE(one["error"], error_limit);
    for (const char* key : {"ns", "bytes_per_edge", "table_bytes", "steps", "lines_per_query", "in_cache_ns"})
        EXPECT_GT(one[key], 0) << key;
    EXPECT_TRUE(one["misses_per_query"].contains("l2_256K")) << one;
    EXPECT_EQ(one["predicted_ns_on"].contains("l2_256K"), has_latencies) << one;
}

/// Splits the command at blanks and gives it to the program, which reads it and does not run it.
void expect_can_be_typed(const std::string& command, const Folder& folder) {
    const std::string words = command.substr(std::string("edgewise ").size());
    EXPECT_EQ(run(called("--parse-only", words_of(words)), folder).exit_code, 0) << command;
}

TEST(Advise, TakesNamesAndExplains) {
    const Folder folder;
    // An earlier process of the same number left a folder behind.
    const Outcome outcome = run_in_shell(
        "left=\"$PWD\"/edgewise-advise-$$; mkdir $left; echo '?' >$left/1.db; TMPDIR=$PWD exec \"$0\" \"$@\"",
        few_cubes({"--error", "1.5e-6", "--machines", "l2=256K"}), folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << "steps are for people";
    const json advice = json::parse(outcome.out);
    EXPECT_EQ(advice["asked"]["shape"], "cube8");
    EXPECT_EQ(advice["asked"]["parameters"]["bodies"], 3);
    EXPECT_EQ(advice["asked"]["error"], 1.5e-6);
    EXPECT_EQ(advice["asked"]["own_tables"], false);
    EXPECT_THAT(advice["asked"]["assumed"].dump(), HasSubstr("--own-tables"));
    expect_raced(advice["take"], 1.5e-6, !advice["latencies_ns"].empty());
    EXPECT_TRUE(advice["take"]["ties"]) << "with itself";
    for (const json& next : advice["next"]) expect_raced(next, 1.5e-6, !advice["latencies_ns"].empty());
    EXPECT_GE(advice["next"].size(), 1U);
    EXPECT_FALSE(is_named(advice["dropped"], advice["take"]));
    for (const json& dropped : advice["dropped"])
        EXPECT_FALSE(dropped["reason"].get<std::string>().empty()) << dropped;
    EXPECT_EQ(advice["processes"], 3);
    EXPECT_LE(advice["noise"]["low"], 1);
    EXPECT_GE(advice["noise"]["high"], 1);
    EXPECT_TRUE(advice["held"].is_boolean() || advice["latencies_ns"].empty()) << advice["held"];
    EXPECT_THAT(advice["changes_it"].dump(), HasSubstr("a table for each body"));
    EXPECT_EQ(advice["not_asked"].size(), 1U) << advice["not_asked"] << ": there was time for all";
    const std::string command = advice["command"];
    EXPECT_THAT(command, HasSubstr("--shape cube8 --bodies 3 --turn 0.1 --shared-tables --error 1.5e-06"));
    EXPECT_THAT(command, HasSubstr("--machines l2=256K"));
    expect_can_be_typed(command, folder);
}

TEST(Advise, TakesNothingWhereNothingMeetsTheError) {
    const Folder folder;
    const Outcome outcome = run(few_cubes({"--error", "1e-300"}), folder);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    const json advice = json::parse(outcome.out);
    EXPECT_TRUE(advice["take"].is_null());
    EXPECT_TRUE(advice["held"].is_null());
    EXPECT_TRUE(advice["noise"].is_null());
    EXPECT_GT(advice["dropped"].size(), 20U);
    for (const json& dropped : advice["dropped"]) EXPECT_GT(dropped["error"], 1e-300) << dropped;
}

/// Too much for the time on any machine there is: what is null is named, and nothing is made up. Cells that
/// no time was left for are listed first, and among them the machine that was named first.
TEST(Advise, NamesFirstWhatItLeftOut) {
    const Folder folder;
    const Arguments command = {"advise",       "--shape", "sphere386", "--bodies",   "600",
                               "--own-tables", "--time",  "5",         "--machines", "l2=256K,zen5"};
    const Outcome outcome = run(with(command, {"--json"}), folder);
    ASSERT_THAT(outcome.exit_code, testing::AnyOf(0, 1)) << outcome.err;
    const json advice = json::parse(outcome.out);
    EXPECT_EQ(outcome.exit_code == 0, !advice["take"].is_null());
    EXPECT_THAT(advice["not_asked"].dump(), HasSubstr("no time was left"));
    EXPECT_LE(advice["processes"], 3);
    if (advice["processes"] < 3) {
        EXPECT_THAT(advice["not_asked"].dump(), HasSubstr("of 3 processes"));
    }
    ASSERT_FALSE(advice["not_asked"].empty());
    std::size_t place = 0;
    for (const char* machine : {"l2_256K", "zen5"}) {
        if (!advice["take"].is_null() && advice["take"]["misses_per_query"].contains(machine)) continue;
        EXPECT_THAT(advice["not_asked"][place++].get<std::string>(), HasSubstr(machine));
    }
    const auto lines = lines_of(run(command, folder).out);
    ASSERT_GT(lines.size(), 3U);
    EXPECT_THAT(lines[2], testing::StartsWith("  left out"));
}

/// The program with a wrong layout (crooked.hpp) and a right one linked in, and no baseline.
TEST(Advise, DropsAWrongCell) {
    const Folder folder;
    const Outcome outcome = Process(crooked_program_path, few_cubes({}), folder).wait();
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
    const json advice = json::parse(outcome.out);
    EXPECT_EQ(advice["take"]["table"], "straight_f64");
    ASSERT_EQ(advice["dropped"].size(), 1U);
    EXPECT_EQ(advice["dropped"][0]["table"], "crooked_f64");
}

TEST(Advise, LeavesNothingBehindAtCtrlC) {
    const Folder folder;
    Process process("/bin/sh", with({"-c", "TMPDIR=$PWD exec \"$0\" \"$@\"", program_path}, few_cubes({})),
                    folder);
    const auto works = [&] {
        return std::ranges::any_of(std::filesystem::directory_iterator(folder.path()),
                                   [](const auto& entry) { return entry.is_directory(); });
    };
    while (!works() && !process.has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    process.send(SIGINT);
    const Outcome outcome = process.wait();
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr("stopped: no advice"));
    EXPECT_FALSE(works());
}

TEST(Advise, AsksASceneFileAndRepeatsIt) {
    const Folder folder;
    folder.write("mine.json", R"({"scene": "static", "shapes": ["cube8"], "needs": "witnesses"})");
    const Outcome outcome =
        run(with({"advise", "--scene", "mine.json", "--error", "1e-300"}, enough_time), folder);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("witnesses"));
    EXPECT_THAT(outcome.out, HasSubstr("nothing meets the error"));
    EXPECT_THAT(outcome.out, HasSubstr("edgewise advise --scene mine.json --error 1e-300 --needs witnesses"));
}

}  // namespace
}  // namespace edgewise::cli_test
