// SPDX-License-Identifier: MIT
//
// A command's output arrives, or the command says so and ends with 2: on a full disk, with a closed
// stdout. And every command needs little address space.
#include <gmock/gmock.h>
#include <signal.h>

#include <set>

#include "commands.hpp"

namespace edgewise::cli_test {
namespace {

/// Every command as text, as JSON and its help; and the help of all.
std::vector<Arguments> all_printing(const Folder& folder) {
    std::vector<Arguments> all = {{"--help"}, {"--help-all"}};
    for (const std::string& command : listed_commands(folder)) {
        all.push_back(called(command, {"--help"}));
        const auto known = printing().find(command);
        if (known == printing().end()) {
            ADD_FAILURE() << "say in `printing` with which arguments " << command << " prints something";
            continue;
        }
        for (const bool as_json : {false, true}) {
            Arguments words = called(command, known->second);
            if (as_json) words.emplace_back("--json");
            all.push_back(words);
        }
    }
    return all;
}

TEST(Output, ThatIsLostIsExitCodeTwoForEveryCommand) {
    const Folder folder;
    const NoOtherPrograms none;
    fill(folder);
    for (const Arguments& words : all_printing(folder)) {
        const std::string command = testing::PrintToString(words);
        const Outcome plain = run(words, folder);
        EXPECT_NE(plain.exit_code, 2) << command << plain.err;
        EXPECT_NE(plain.out, "") << command;
        for (const auto& [to, reason] : std::map<std::string, std::string>{
                 {">/dev/full", "No space left on device"}, {">&-", "Bad file descriptor"}}) {
            const Outcome lost = run_in_shell("\"$0\" \"$@\" " + to, words, folder);
            EXPECT_EQ(lost.exit_code, 2) << command << to;
            EXPECT_EQ(lost.err,
                      plain.err + "edgewise: stdout: " + reason + ": what was printed is incomplete\n")
                << command << to;
        }
    }
}

/// Tables reserve all the addresses that they could ever need. If there are too few, they grow step by
/// step, and every traced address is the same as before.
TEST(Memory, OfFourGibibytesOfAddressesIsEnoughForEveryCommand) {
    const Folder folder;
    const NoOtherPrograms none;
    fill(folder);
    const std::set<std::string> exact = {"bytes", "caches", "draw", "judge", "lock", "query"};
    for (const Arguments& words : all_printing(folder)) {
        const Outcome plain = run(words, folder);
        const Outcome limited = run_in_shell("ulimit -v 4194304 && exec \"$0\" \"$@\"", words, folder);
        EXPECT_EQ(limited.exit_code, plain.exit_code) << testing::PrintToString(words) << limited.err;
        EXPECT_EQ(limited.err, plain.err) << testing::PrintToString(words);
        if (exact.contains(words[0])) {
            EXPECT_EQ(limited.out, plain.out) << testing::PrintToString(words);
        }
    }
}

/// A reader that has enough ends the program without a word, as it ends other programs.
TEST(Output, ToAReaderThatLeftEndsBySigpipe) {
    const Folder folder;
    const Outcome outcome =
        run_in_shell("(sleep 0.5; \"$0\" \"$@\"; echo $? >code) | true", {"--help-all"}, folder);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(text_of(folder / "code"), std::to_string(128 + SIGPIPE) + "\n");
}

/// With stdout closed, the next file to be opened must not become stdout.
TEST(Output, IsNotWrittenIntoAFileThatTookThePlaceOfStdout) {
    const Folder folder;
    const Outcome outcome = run_in_shell(
        "\"$0\" \"$@\" >&-", {"caches", "--shape", "cube8", "--queries", "20", "--write", "t.din"}, folder);
    EXPECT_EQ(outcome.exit_code, 2);
    const std::vector<std::string> lines = lines_of(text_of(folder / "t.din"));
    ASSERT_GT(lines.size(), 100U);
    for (const std::string& line : lines)
        ASSERT_TRUE(line.starts_with("r ") || line.starts_with("w ")) << line;
}

}  // namespace
}  // namespace edgewise::cli_test
