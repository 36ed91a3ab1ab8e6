// SPDX-License-Identifier: MIT
//
// A command's output arrives, or the command says so and ends with 2: on a full disk, with a closed
// stdout. And every command needs little address space.
#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>
#include <set>

#include "commands.hpp"

namespace edgewise::cli_test {
namespace {

/// Its parameter: a command of `printing`, or "" for the help of all.
class EveryCommand : public testing::TestWithParam<std::string> {
  protected:
    /// Its help; with arguments that print something, its text and its JSON.
    [[nodiscard]] static std::vector<Arguments> command_lines() {
        if (GetParam().empty()) return {{"--help"}, {"--help-all"}};
        const Arguments words = called(GetParam(), printing().at(GetParam()));
        return {called(GetParam(), {"--help"}), words, with(words, {"--json"})};
    }

    void expect_loss_is_said(const Arguments& words, const Outcome& plain, bool is_closed) const {
        const std::string to = is_closed ? ">&-" : ">/dev/full",
                          reason = is_closed ? "Bad file descriptor" : "No space left on device";
        const Outcome lost = run_in_shell("\"$0\" \"$@\" " + to, words, folder_);
        EXPECT_EQ(lost.exit_code, 2) << to;
        EXPECT_EQ(lost.err, plain.err + "edgewise: stdout: " + reason + ": what was printed is incomplete\n")
            << to;
    }

    /// Tables reserve all the addresses that they could ever need. If there are too few, they grow step by
    /// step, and every traced address is the same as before.
    void expect_the_same_in_four_gibibytes(const Arguments& words, const Outcome& plain) const {
        const std::set<std::string> exact = {"bytes", "caches", "draw", "judge", "lock", "query"};
        const Outcome limited = run_in_shell("ulimit -v 4194304 && exec \"$0\" \"$@\"", words, folder_);
        EXPECT_EQ(limited.exit_code, plain.exit_code) << limited.err;
        EXPECT_EQ(limited.err, plain.err);
        if (exact.contains(words[0])) {
            EXPECT_EQ(limited.out, plain.out);
        }
    }

    Folder folder_;
};

/// One place looks at stdout for all commands: each is asked for each kind of loss, not for all of them with
/// all its words.
TEST_P(EveryCommand, SaysThatOutputIsLostAndNeedsFewAddresses) {
    const NoOtherPrograms none;
    fill(folder_);
    const std::vector<Arguments> lines = command_lines();
    for (const Arguments& words : lines) {
        SCOPED_TRACE(testing::PrintToString(words));
        const Outcome plain = run(words, folder_);
        EXPECT_NE(plain.exit_code, 2) << plain.err;
        EXPECT_NE(plain.out, "");
        expect_loss_is_said(words, plain, words == lines.back());
        if (words == lines[1]) expect_the_same_in_four_gibibytes(words, plain);
    }
}

std::vector<std::string> all_with_arguments() {
    std::vector<std::string> commands = {""};
    for (const auto& [command, arguments] : printing()) commands.push_back(command);
    return commands;
}

INSTANTIATE_TEST_SUITE_P(Of, EveryCommand, testing::ValuesIn(all_with_arguments()), [](const auto& command) {
    std::string name = command.param.empty() ? "all" : command.param;
    std::ranges::replace(name, ' ', '_');
    return name;
});

TEST(Commands, AreAllKnownWithArgumentsThatPrint) {
    const Folder folder;
    std::vector<std::string> known = all_with_arguments();
    known.erase(known.begin());
    EXPECT_THAT(listed_commands(folder), testing::UnorderedElementsAreArray(known))
        << "say in `printing` with which arguments a command prints something";
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
