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

/// With no more than 1 GB of addresses, of which tables reserve more.
Outcome run_in_little_memory(const Arguments& arguments, const Folder& folder) {
    Arguments words = {"-c", "ulimit -v 1000000 && exec \"$0\" \"$@\"", program_path};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return Process("/bin/sh", words, folder).wait();
}

/// Where no cell can have any, the sweep ends before the first, and blames no check.
TEST(Memory, ThatTablesLackIsOneLine) {
    const Folder folder;
    const Outcome outcome = run_in_little_memory(
        {"sweep", "--scenes", "cold", "--shapes", "cube8", "--layouts", "aos_f64", "--queries", "50",
         "--checked", "10", "--rounds", "2", "--store", "s.db", "--json"},
        folder);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("out of memory"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("check")));
}

TEST(Memory, ThatQueriesLackIsOneLine) {
    const Folder folder;
    const Outcome outcome =
        run_in_little_memory({"bench", "--shape", "cube8", "--queries", "100000000"}, folder);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("out of memory: ask for fewer queries"));
}

}  // namespace
}  // namespace edgewise::cli_test
