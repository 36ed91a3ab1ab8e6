// SPDX-License-Identifier: MIT
//
// `edgewise paging` ended by a signal: the control group that limited its memory is gone with it.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "cli_paths.hpp"
#include "program.hpp"

namespace edgewise::cli_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// Returns true if a control group of that name exists anywhere.
bool has_group(const std::string& name) {
    std::error_code error;
    for (fs::recursive_directory_iterator at("/sys/fs/cgroup", error), end; !error && at != end;
         at.increment(error)) {
        if (at->path().filename() == name) return true;
    }
    return false;
}

class Paging : public testing::TestWithParam<int> {};

TEST_P(Paging, LeavesNoControlGroup) {
    const Folder folder;
    Process process(program_path, {"paging", "--bodies", "200", "--steps", "4", "--layouts", "aos_f64"},
                    folder);
    const std::string group = "edgewise-" + std::to_string(process.id());
    bool seen = false;
    while (!seen && !process.has_ended()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        seen = has_group(group);
    }
    process.send(GetParam());
    const Outcome outcome = process.wait();
    if (!seen) {
        EXPECT_THAT(outcome.out, HasSubstr("no memory limit")) << "nothing was limited";
        GTEST_SKIP() << "no control group can be made here";
    }
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("stopped"));
    EXPECT_FALSE(has_group(group));
}

INSTANTIATE_TEST_SUITE_P(EndedBy, Paging, testing::Values(SIGTERM, SIGINT),
                         [](const auto& signal) { return signal.param == SIGTERM ? "Sigterm" : "CtrlC"; });

// What `edgewise paging thrash` says: every combination scored, and cells made real or the reason.

const Arguments few_settings = {"paging",          "thrash", "--layouts",  "aos_f64", "--bodies", "20",
                                "--memory",        "1,16",   "--fault-ns", "20000",   "--steps",  "12",
                                "--point-seconds", "0.02"};

TEST(Thrash, ScoresSettingsAndMakesTheBestReal) {
    const Folder folder;
    const Outcome found = run(with(few_settings, {"--realised", "1", "--json"}), folder);
    ASSERT_EQ(found.exit_code, 0) << found.err;
    const json told = json::parse(found.out);
    EXPECT_EQ(told["calibrations"].size(), 3U * 2);
    for (const json& calibration : told["calibrations"]) {
        EXPECT_GT(calibration["ns_per_read"], 0);
        EXPECT_THAT(calibration["model_over_paper"], testing::SizeIs(3));
    }
    std::size_t settings = 0;
    for (const json& group : told["groups"]) {
        EXPECT_EQ(group["settings"], 2U);
        EXPECT_LE(group["with_all"], group["with"]["rises"]);
        settings += group["settings"].get<std::size_t>();
    }
    // 12 mechanisms with own tables, 11 with shared ones; time steps, machines, memories.
    EXPECT_EQ(settings, (12U + 11) * 2 * 3 * 2);
    ASSERT_EQ(told["realised"].size(), 1U);
    const json& cell = told["realised"][0];
    if (cell["curves"].is_null()) {
        EXPECT_THAT(cell["reason"].get<std::string>(), HasSubstr("userfaultfd"));
    } else {
        ASSERT_EQ(cell["curves"].size(), 4U);
        for (const json& curve : cell["curves"])
            for (const json& point : curve["points"]) EXPECT_TRUE(point["same_answers"]);
    }
}

TEST(Thrash, PrintsATableForPeople) {
    const Folder folder;
    const Outcome found = run(with(few_settings, {"--realised", "0"}), folder);
    ASSERT_EQ(found.exit_code, 0) << found.err;
    EXPECT_THAT(found.out, testing::AllOf(HasSubstr("model /"), HasSubstr("figure_4"),
                                          HasSubstr("whole_table_transform"), HasSubstr("spares")));
}

}  // namespace
}  // namespace edgewise::cli_test
