// SPDX-License-Identifier: MIT
//
// What `edgewise paging thrash` says: every combination scored, cells made real or the reason, and bad input.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli_paths.hpp"
#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const Arguments few_settings = {"paging",  "thrash",   "--layouts", "aos_f64",    "--bodies",
                                "20",      "--memory", "1,16",      "--fault-ns", "20000",
                                "--steps", "12",       "--wait",    "0.02"};

Arguments few_settings_with(const Arguments& more) {
    Arguments arguments = few_settings;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(Thrash, ScoresSettingsAndMakesTheBestReal) {
    const Folder folder;
    const Outcome found = run(few_settings_with({"--realised", "1", "--json"}), folder);
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
    const Outcome found = run(few_settings_with({"--realised", "0"}), folder);
    ASSERT_EQ(found.exit_code, 0) << found.err;
    EXPECT_THAT(found.out, testing::AllOf(HasSubstr("model /"), HasSubstr("figure_4"),
                                          HasSubstr("whole_table_transform"), HasSubstr("spares")));
}

TEST(Thrash, RefusesWhatCannotBe) {
    const Folder folder;
    EXPECT_EQ(run({"paging", "thrash", "--bodies", "1"}, folder).exit_code, 2);
    const Outcome unknown = run({"paging", "thrash", "--layouts", "nowhere"}, folder);
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("nowhere"));
}

}  // namespace
}  // namespace edgewise::cli_test
