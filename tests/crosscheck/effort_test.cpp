// SPDX-License-Identifier: MIT
//
// `edgewise bench effort` in the program that Valgrind can run: it must find the number of instructions of a
// library of known cost, give our own figures twice, and print a message if a tool is missing.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "crosscheck_paths.hpp"
#include "program.hpp"

namespace edgewise {
namespace {

using namespace cli_test;
using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// Path of the program, copied next to the modules of this test.
std::string program_in(const Folder& folder) {
    const fs::path program = folder / "edgewise_sim";
    if (fs::exists(program)) return program;
    std::error_code other_disk;
    fs::create_hard_link(cells_program, program, other_disk);
    if (other_disk) fs::copy_file(cells_program, program);
    fs::create_directory(folder / "sim_peers");
    for (const auto& module : fs::directory_iterator(known_cost_modules))
        fs::copy_file(module.path(), folder / "sim_peers" / module.path().filename());
    return program;
}

/// Rows by table type; by default of GJK on aos_f64.
std::map<std::string, json> effort(const Folder& folder, const Arguments& more,
                                   const Arguments& environment = {}) {
    Arguments arguments = environment;
    arguments.insert(arguments.end(),
                     {program_in(folder), "bench", "effort", "--json", "--layouts", "aos_f64", "--algorithms",
                      "gjk", "--shape", "sphere38", "--queries", "50", "--checked", "10"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = Process("/usr/bin/env", arguments, folder).wait();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::map<std::string, json> rows;
    if (outcome.exit_code != 0) return rows;
    const json printed = json::parse(outcome.out);
    for (const json& row : printed.at("effort")) rows[row.at("table")] = row;
    return rows;
}

double value(const json& row, const char* figure) {
    const json& found = row.at("figures").at(figure);
    EXPECT_TRUE(found.at("value").is_number()) << figure << ": " << found;
    return found.at("value").is_number() ? found.at("value").get<double>() : std::nan("");
}

/// Besides the loop, a query includes the bench's own code. The difference between the two libraries is the
/// loop alone, to the instruction.
TEST(EffortOfAPeer, FindsAKnownNumberOfInstructions) {
    const Folder folder;
    const auto rows = effort(folder, {"--peers", "known_cost"});
    ASSERT_EQ(rows.size(), 3U);
    const json &lesser = rows.at("known_cost_f64"), &greater = rows.at("known_cost_mixed");
    const double less = value(lesser, "effort.instructions"), more = value(greater, "effort.instructions");
    EXPECT_GE(less, 2 * 1000);
    EXPECT_LE(less, 2 * 1000 + 100);
    EXPECT_NEAR(more - less, 2 * (5000 - 1000), 0.5);
    EXPECT_LE(value(lesser, "effort.mispredictions"), 3);
    std::printf("effort: %.2f and %.2f instructions per query of loops of 2000 and 10000\n", less, more);
    EXPECT_EQ(lesser.at("status"), "judged");
    EXPECT_THAT(lesser.at("reason").dump(), HasSubstr("wrong")) << "its answer is always 1";
    EXPECT_THAT(lesser.at("figures").at("effort.steps").at("reason").dump(), HasSubstr("library"));
    // The coordinates of 38 vertices, and the overhead of the allocator.
    EXPECT_GE(value(lesser, "bytes.table_bytes"), 38 * 24);
    EXPECT_LE(value(lesser, "bytes.table_bytes"), 38 * 24 + 64);
}

/// Instructions depend on the program only. The environment moves the stack, which changes a few misses, and
/// one misprediction of a pass of 50 queries (8.23 or 8.25 per query in 14 environments).
TEST(Effort, IsTheSameInAnotherEnvironment) {
    const Folder here, there;
    const auto first = effort(here, {}).at("aos_f64");
    const auto second =
        effort(there, {}, {"-i", "PATH=/usr/bin:/bin", "PADDING=" + std::string(3000, 'x')}).at("aos_f64");
    for (const auto& [name, figure] : first.at("figures").items()) {
        const json& other = second.at("figures").at(name);
        if (!figure.at("value").is_number()) {
            EXPECT_EQ(figure, other) << name;
            continue;
        }
        const double a = figure.at("value"), b = other.at("value");
        const bool branches = name.find("mispredictions") != std::string::npos;
        const double slack = name.ends_with("_misses") ? 2 : branches ? 0.1 : 1e-3 * a;
        EXPECT_NEAR(a, b, slack) << name;
    }
    EXPECT_GT(value(first, "effort.instructions"), 500);
    EXPECT_GT(value(first, "effort.mispredictions"), 1);
    EXPECT_GT(value(first, "effort.lines_over_floor"), 1);
    std::printf("effort: %.2f and %.2f instructions, %.3f and %.3f mispredictions per query\n",
                value(first, "effort.instructions"), value(second, "effort.instructions"),
                value(first, "effort.mispredictions"), value(second, "effort.mispredictions"));
}

/// The phases of default cells add up to Callgrind's total, and at most 3 % of instructions belong to
/// functions that the table of phases (studies/phases/phases.json) does not name.
TEST(EffortByPhase, KnowsWhereNearlyAllInstructionsAreFrom) {
    const Folder folder;
    const Arguments arguments = {"bench",     "effort",    "--by-phase",
                                 "--json",    "--layouts", "aos_f64,lean_f64,points_soa_f64",
                                 "--queries", "50"};
    const Outcome outcome = Process(program_in(folder), arguments, folder).wait();
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json printed = json::parse(outcome.out), &rows = printed.at("effort_by_phase");
    EXPECT_EQ(rows.size(), 5U);
    for (const json& row : rows) {
        const json& total = row.at("total");
        double sum = 0, other = 0;
        for (const json& phase : row.at("phases")) {
            sum += phase.at("instructions").get<double>();
            const bool unknown = phase.at("phase") == "other" || phase.at("phase") == "arithmetic, shared";
            if (unknown) other += phase.at("instructions").get<double>();
        }
        const double all = total.at("instructions");
        EXPECT_GT(all, 500);
        EXPECT_NEAR(sum, all, 1e-9 * all);
        EXPECT_LE(other, 0.03 * all) << row.at("others");
        EXPECT_GT(total.at("instructions_in_steps"), 0.2 * all);
        const std::size_t code = row.at("code_bytes");
        EXPECT_EQ(code % 64, 0U);
        EXPECT_GT(code, 1024U);
        EXPECT_LT(code, 131072U);
        std::printf("effort by phase: %.0f instructions in %zu bytes of code, %.3f %% of them other\n", all,
                    code, 100 * other / all);
    }
}

/// The total by phase is the total without phases, also in a scene without rotation.
TEST(EffortByPhase, CountsWhatEffortCounts) {
    const Folder folder;
    const Arguments cell = {"--json",       "--scene", "cold",      "--layouts", "aos_f64",
                            "--algorithms", "vclip",   "--queries", "50"};
    const auto total_of = [&](Arguments arguments) {
        arguments.insert(arguments.end(), cell.begin(), cell.end());
        return json::parse(Process(program_in(folder), arguments, folder).wait().out);
    };
    const double by_phase = total_of({"bench", "effort", "--by-phase"})
                                .at("effort_by_phase")
                                .at(0)
                                .at("total")
                                .at("instructions");
    EXPECT_DOUBLE_EQ(by_phase,
                     value(total_of({"bench", "effort"}).at("effort").at(0), "effort.instructions"));
}

TEST(Effort, WithoutValgrindSaysSo) {
    const Folder folder;
    const json row = effort(folder, {}, {"-i", "PATH=/nowhere"}).at("aos_f64");
    const json& figure = row.at("figures").at("effort.instructions");
    EXPECT_TRUE(figure.at("value").is_null());
    EXPECT_THAT(figure.at("reason").dump(), HasSubstr("valgrind"));
    EXPECT_THAT(figure.at("remedy").dump(), HasSubstr("install valgrind"));
    EXPECT_GT(value(row, "effort.steps"), 0);
}

}  // namespace
}  // namespace edgewise
