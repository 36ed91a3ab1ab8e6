// SPDX-License-Identifier: MIT
//
// In a build that Valgrind can run: compares real cells with Callgrind, and the deterministic figures of this
// build with those of the program that is tuned to this machine, in another environment.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "crosscheck_paths.hpp"
#include "deterministic_figures.hpp"

namespace edgewise {
namespace {

using namespace cli_test;
using nlohmann::json;

struct Cell {
    const char *name, *table, *algorithm, *shape;
    Arguments more;
};
void PrintTo(const Cell& cell, std::ostream* out) { *out << cell.name; }

class CrosscheckCells : public testing::TestWithParam<Cell> {};

/// Machines with every geometry of a first level in the manifest, and four of a second level.
constexpr const char* machines =
    "pentium2_deschutes,pentium3_coppermine,athlon_thunderbird,skylake_sp,zen5,raspberry_pi4";

/// Lines per query by which the tool may exceed the model. Besides tables, pair caches and poses, the tool
/// sees the stack, constants, answers and instructions. In the 16 KiB of the Pentiums these may also evict
/// lines in every pass over a table that nearly fills the cache. In the two ways of the Raspberry Pi and of
/// the Athlon any three lines that share a set miss each time: about twenty lines of the stack and of
/// constants, in at most five iterations each. Their sets depend by chance on the length of the environment
/// and on the linker (4 to 74 misses per query of one cell seen on the Raspberry Pi), so the bound there
/// starts from the model without the ways of the stack.
double most_beyond(const std::string& machine) {
    if (machine == "raspberry_pi4") return 100;
    if (machine == "athlon_thunderbird") return 50;
    return machine.starts_with("pentium") ? 14 : 7.5;
}

/// In the last level the tool also holds the stack, constants and instructions, which take lines of a table
/// that nearly fills the cache, by chance (13.9 to 14.2 misses of a model of 11.6 seen in several
/// environments): it may exceed the model with one way less by 1.5 lines per query. It may have that much and
/// a tenth of the misses less than the model: a query's record is not read to its last byte. With lines of
/// 32 bytes it may have up to half of the misses on poses less: a wide load of a pose lies in two lines, and
/// Callgrind counts it once.
TEST_P(CrosscheckCells, AgreeButForTheStack) {
    const Cell& cell = GetParam();
    const Folder folder;
    Arguments arguments = {"bench",       "crosscheck",   "--json",  "--table",  cell.table,
                           "--algorithm", cell.algorithm, "--shape", cell.shape, "--queries",
                           "400",         "--machines",   machines};
    arguments.insert(arguments.end(), cell.more.begin(), cell.more.end());
    const Outcome outcome = Process(cells_program, arguments, folder).wait();
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json rows = json::parse(outcome.out)["crosscheck"];
    ASSERT_EQ(rows.size(), 6U);
    double worst = 0, most_modelled = 0, worst_ll = 0;
    for (const json& row : rows) {
        ASSERT_TRUE(row["reason"].is_null()) << row;
        const bool small_lines = row["machine"].get<std::string>().starts_with("pentium");
        const json &ours = row["model_with_poses"], &theirs = row["callgrind"];
        const double model = ours["d1_misses_per_query"], tool = theirs["d1_misses_per_query"];
        const double of_poses = model - row["model"]["d1_misses_per_query"].get<double>();
        EXPECT_GT(tool, model - 0.8 - (small_lines ? of_poses / 2 : 0)) << row;
        const bool by_chance =
            small_lines || row["machine"] == "raspberry_pi4" || row["machine"] == "athlon_thunderbird";
        const double most = by_chance ? row["at_most"]["d1_misses_per_query"].get<double>() : model;
        EXPECT_LT(tool, most + most_beyond(row["machine"])) << row;
        EXPECT_TRUE(by_chance || tool < 25 || model > 0.75 * tool) << row;
        const double model_ll = ours["ll_misses_per_query"], tool_ll = theirs["ll_misses_per_query"];
        EXPECT_GT(tool_ll, 0.9 * model_ll - 1.5) << row;
        EXPECT_LT(tool_ll, row["at_most"]["ll_misses_per_query"].get<double>() + 1.5) << row;
        worst = std::max(worst, std::abs(tool - model));
        worst_ll = std::max(worst_ll, std::abs(tool_ll - model_ll));
        most_modelled = std::max(most_modelled, model);
    }
    EXPECT_GT(most_modelled, 3) << "nothing was missed";
    std::printf(
        "%s: to %.1f D1 misses per query; %.2f per query between them at most, in the last level %.3f\n",
        cell.name, most_modelled, worst, worst_ll);
}

INSTANTIATE_TEST_SUITE_P(
    Of, CrosscheckCells,
    testing::Values(
        Cell{"vclip_tumble", "aos_f64", "vclip", "sphere386", {"--parameter", "rotation_step=0.3"}},
        Cell{"gjk_tumble", "points_soa_f64", "gjk", "sphere386", {"--parameter", "rotation_step=0.3"}},
        Cell{"lean_static", "lean_f32", "vclip", "sphere38", {"--scene", "static"}},
        Cell{"vclip_frames",
             "aos_f32",
             "vclip",
             "sphere386",
             {"--parameter", "in_time_order=1", "--parameter", "bodies=30"}}),
    [](const auto& cell) { return std::string(cell.param.name); });

TEST(Builds, GiveTheSameFiguresInEveryEnvironment) {
    const Folder here, there;
    const Figures ours = deterministic_figures(cells_program, {}, here);
    const Figures theirs = deterministic_figures(
        tuned_program,
        {"-i", "PATH=/usr/bin:/bin", "LC_ALL=POSIX", "TMPDIR=/tmp", "PADDING=" + std::string(3000, 'x')},
        there);
    EXPECT_GT(ours.size(), 5000U);
    EXPECT_EQ(ours, theirs);
    std::printf("%zu deterministic figures are the same in both builds and environments\n", ours.size());
}

}  // namespace
}  // namespace edgewise
