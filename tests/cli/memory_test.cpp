// SPDX-License-Identifier: MIT
//
// The program where there is too little memory: it says so, and blames nothing else.
#include <gmock/gmock.h>

#include "cli_paths.hpp"
#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using testing::HasSubstr;
using testing::Not;

Outcome run_within(int kibibytes, const Arguments& arguments, const Folder& folder) {
    return run_in_shell("ulimit -v " + std::to_string(kibibytes) + " && exec \"$0\" \"$@\"", arguments,
                        folder);
}

/// A crowd of bodies with 1 GB of tables, where there are 300 MB of addresses.
TEST(Memory, ThatTablesLackIsOneLine) {
    const Folder folder;
    folder.write("crowd.json", R"({"scene": "pressure", "shapes": ["sphere386"], "sharing": "per_instance",
                                   "parameters": {"bodies": 5000}, "queries": 200})");
    for (const Arguments& words :
         {Arguments{"bench", "model", "--scene", "pressure", "--shape", "sphere386", "--queries", "100",
                    "--parameter", "bodies=5000", "own_tables=1"},
          Arguments{"sweep", "--scenes", "crowd.json", "--layouts", "aos_f64", "--checked", "10", "--rounds",
                    "2", "--store", "s.db", "--json"}}) {
        const Outcome outcome = run_within(300'000, words, folder);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("address space"));
        EXPECT_THAT(outcome.err, HasSubstr("ulimit -v"));
        EXPECT_THAT(outcome.err, Not(HasSubstr("check")));
    }
}

TEST(Memory, ThatQueriesLackIsOneLine) {
    const Folder folder;
    const Outcome outcome =
        run_within(1'000'000, {"bench", "model", "--shape", "cube8", "--queries", "100000000"}, folder);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("out of memory: ask for fewer queries"));
}

}  // namespace
}  // namespace edgewise::cli_test
