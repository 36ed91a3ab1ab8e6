// SPDX-License-Identifier: MIT
//
// What a command prints or writes arrives, or the command says so and ends with 2: on a full disk, with a
// closed stdout, and whatever stands where a file is to be written.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <set>
#include <thread>

#include "cli_paths.hpp"
#include "program.hpp"

namespace edgewise::cli_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* a_case =
    R"({"a":{"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]},"b":{"vertices":[[3,0,0],[4,0,0],[3,1,0],[3,0,1]]}})"
    "\n";

/// A store, a machine record and a case file, as commands read them.
void fill(const Folder& folder) {
    ASSERT_EQ(run({"sweep", "--scenes", "cold", "--shapes", "cube8", "--layouts", "aos_f64", "--queries",
                   "50", "--checked", "10", "--rounds", "2", "--store", "s.db", "--no-report"},
                  folder)
                  .exit_code,
              0);
    ASSERT_EQ(run({"export", "s.db", "--machine-record", "--out", "r.json"}, folder).exit_code, 0);
    folder.write("c.jsonl", a_case);
}

/// Cheap arguments with which a command prints something.
const std::map<std::string, Arguments> printing = {
    {"advise", {"--store", "s.db"}},
    {"bench", {"--shape", "cube8", "--queries", "20", "--repetitions", "1"}},
    {"budget", {"--shape", "sphere38"}},
    {"bytes", {"--layouts", "aos_f64"}},
    {"caches", {"--shape", "cube8", "--queries", "20"}},
    {"calibrate", {"--loads", "1000", "--times", "0.01"}},
    {"campaign", {"--pairs", "50", "--families", "random", "--shapes", "cube8", "--layouts", "aos_f64"}},
    {"claims", {"s.db"}},
    {"compare", {"r.json"}},
    {"crosscheck", {"--shape", "cube8", "--queries", "20"}},
    {"draw", {"layout", "aos_f64", "--shape", "tetra4"}},
    {"effort", {"--shape", "cube8", "--queries", "20", "--layouts", "aos_f64", "--checked", "5"}},
    {"export", {"s.db"}},
    {"fields", {"--shape", "cube8", "--queries", "50", "--rounds", "9", "--checked", "5"}},
    {"heat", {"--shape", "cube8", "--queries", "20"}},
    {"judge", {"c.jsonl", "--layouts", "aos_f64"}},
    {"list", {"layouts"}},
    {"lock", {"--shape", "cube8", "--queries", "10"}},
    {"machine", {}},
    {"merge", {"s.db", "--out", "m.db"}},
    {"paging",
     {"--bodies", "4", "--steps", "1", "--shape", "cube8", "--layouts", "aos_f64", "--limits", "0"}},
    {"progress", {"s.db"}},
    {"query", {"c.jsonl"}},
    {"report", {"s.db", "--out", "report"}},
    {"scaling", {"--shape", "cube8", "--queries", "50", "--rounds", "1", "--threads", "1", "--checked", "5"}},
    {"stability",
     {"--count", "1", "--layouts", "aos_f64", "--families", "slivers_and_needles", "--store", "t.db"}},
    {"sweep",
     {"--scenes", "cold", "--shapes", "cube8", "--layouts", "aos_f64", "--queries", "50", "--checked", "10",
      "--rounds", "2", "--store", "s.db", "--no-report"}},
    {"thrash",
     {"--layouts", "aos_f64", "--bodies", "8", "--memory", "1", "--fault-ns", "1000", "--steps", "12",
      "--realised", "0"}},
};

/// While it lives, commands find no Valgrind, which takes its time: they say so, and print the rest.
class NoOtherPrograms {
  public:
    NoOtherPrograms() { setenv("PATH", "/nowhere", 1); }
    ~NoOtherPrograms() { setenv("PATH", before_.c_str(), 1); }
    NoOtherPrograms(const NoOtherPrograms&) = delete;
    NoOtherPrograms& operator=(const NoOtherPrograms&) = delete;

  private:
    std::string before_ = std::getenv("PATH");
};

/// Every command as text, as JSON and its help; and the help of all.
std::vector<Arguments> all_printing(const Folder& folder) {
    std::vector<Arguments> all = {{"--help"}, {"--help-all"}};
    for (const std::string& command : listed_commands(folder)) {
        all.push_back({command, "--help"});
        const auto known = printing.find(command);
        if (known == printing.end()) {
            ADD_FAILURE() << "say in `printing` with which arguments " << command << " prints something";
            continue;
        }
        for (const bool json : {false, true}) {
            Arguments words = {command};
            words.insert(words.end(), known->second.begin(), known->second.end());
            if (json) words.emplace_back("--json");
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

/// Tables ask for all the addresses that they could ever need. Where there are not so many, they grow step by
/// step, and every address that is traced is the same as before.
TEST(Memory, OfFourGibibytesOfAddressesIsEnoughForEveryCommand) {
    const Folder folder;
    const NoOtherPrograms none;
    fill(folder);
    const std::set<std::string> exact = {"bytes", "caches", "draw", "heat", "judge", "lock", "query"};
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
        run_in_shell("(\"$0\" \"$@\"; echo $? >code) | true; sleep 0.2", {"--help-all"}, folder);
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

/// An option that names a file to be written.
struct Writer {
    Arguments arguments;  ///< without the file, which follows the option
    bool is_text = true;  ///< written through to a pipe, and longer than 512 bytes
    Arguments more = {};  ///< after the file
};

const std::map<std::string, Writer> writers = {
    {"export --out", {{"export", "s.db"}}},
    {"caches --write", {{"caches", "--shape", "cube8", "--queries", "200"}}},
    {"fields --write",
     {{"fields", "--shape", "cube8", "--queries", "50", "--rounds", "9", "--checked", "5"}, true}},
    {"fields --svg", {{"fields", "--shape", "cube8", "--queries", "50", "--rounds", "9", "--checked", "5"}}},
    {"campaign --state",
     {{"campaign", "--pairs", "50", "--families", "random", "--shapes", "cube8", "--layouts", "aos_f64"},
      false}},
    {"campaign --failures",
     {{"campaign", "--pairs", "50", "--families", "random", "--shapes", "cube8", "--layouts", "aos_f64"},
      false}},
    {"merge --out", {{"merge", "s.db"}, false}},
    {"bench --gate",
     {{"bench", "--rounds", "9", "--queries", "50", "--layouts", "aos_f64"}, true, {"--write"}}},
};

Arguments writing(const std::string& option, const std::string& file) {
    const Writer& writer = writers.at(option);
    Arguments words = writer.arguments;
    words.insert(words.end(), {option.substr(option.find("--")), file});
    words.insert(words.end(), writer.more.begin(), writer.more.end());
    return words;
}

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
}

/// Whose cheap runs have nothing to write.
bool writes_nothing(const std::string& option) { return option == "campaign --failures"; }

TEST(OutputFile, OfEveryCommandIsTested) {
    const Folder folder;
    for (const std::string& command : listed_commands(folder)) {
        for (const ListedOption& option : listed_options(command, folder)) {
            if (option.type == "FILE") {
                EXPECT_TRUE(writers.contains(command + " " + option.name))
                    << "say in `writers` how " << command << " writes " << option.name;
            }
        }
    }
}

TEST(OutputFile, ThatIsALinkLeadsToWhatIsWritten) {
    const Folder folder;
    fill(folder);
    fs::create_directory(folder / "there");
    fs::create_directory(folder / "here");
    for (const auto& [option, writer] : writers) {
        if (writes_nothing(option)) continue;
        for (const bool exists : {false, true}) {
            fs::create_symlink("../there/file", folder / "here" / "link");
            fs::create_symlink("link", folder / "here" / "link_of_link");
            const Outcome outcome = run(writing(option, "here/link_of_link"), folder);
            EXPECT_EQ(outcome.exit_code, 0) << option << outcome.err;
            EXPECT_TRUE(fs::is_symlink(folder / "here" / "link_of_link")) << option;
            EXPECT_TRUE(fs::is_symlink(folder / "here" / "link")) << option;
            EXPECT_THAT(names_in(folder / "here"), testing::ElementsAre("link", "link_of_link")) << option;
            EXPECT_THAT(names_in(folder / "there"), testing::ElementsAre("file")) << option;
            EXPECT_GT(fs::file_size(folder / "there" / "file"), 10U) << option << exists;
            fs::remove(folder / "here" / "link");
            fs::remove(folder / "here" / "link_of_link");
        }
        fs::remove(folder / "there" / "file");
    }
}

TEST(OutputFile, ThatIsAPipeIsWrittenThroughOrRefused) {
    const Folder folder;
    fill(folder);
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (const auto& [option, writer] : writers) {
        const Outcome outcome = run_in_shell(
            writer.is_text ? "timeout 60 cat pipe >got & \"$0\" \"$@\"; code=$?; wait; exit $code"
                           : ": >got; timeout 60 \"$0\" \"$@\"",
            writing(option, "pipe"), folder);
        EXPECT_TRUE(fs::is_fifo(folder / "pipe")) << option;
        EXPECT_FALSE(fs::exists(folder / "pipe.tmp")) << option;
        if (writes_nothing(option)) continue;
        EXPECT_EQ(outcome.exit_code, writer.is_text ? 0 : 2) << option << outcome.err;
        EXPECT_EQ(fs::file_size(folder / "got") > 10, writer.is_text) << option;
        if (!writer.is_text) {
            EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
        }
    }
}

/// A device of the test's own, never one of the machine.
TEST(OutputFile, ThatIsADeviceStaysADevice) {
    const Folder folder;
    fill(folder);
    const fs::path full = folder / "full";
    if (mknod(full.c_str(), S_IFCHR | 0666, makedev(1, 7)) != 0) GTEST_SKIP() << "no device can be made here";
    for (const auto& [option, writer] : writers) {
        if (writes_nothing(option)) continue;
        const Outcome outcome = run(writing(option, "full"), folder);
        EXPECT_EQ(outcome.exit_code, 2) << option;
        EXPECT_EQ(lines_of(outcome.err).size(), 1U) << option << outcome.err;
        EXPECT_TRUE(fs::is_character_file(full)) << option;
    }
    EXPECT_THAT(run(writing("export --out", "full"), folder).err,
                HasSubstr("full: cannot be written: No space"));
}

TEST(OutputFile, ThatIsAFolderOrASocketIsRefusedBeforeAnyWork) {
    const Folder folder;
    fs::create_directory(folder / "folder");
    ASSERT_EQ(mknod((folder / "socket").c_str(), S_IFSOCK | 0666, 0), 0);
    folder.write("s.db", "");
    for (const auto& [option, writer] : writers) {
        for (const std::string name : {"folder", "socket", "folder/"}) {
            const Outcome outcome = run(writing(option, name), folder);
            EXPECT_EQ(outcome.exit_code, 2) << option;
            EXPECT_EQ(outcome.out, "") << option;
            EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
            EXPECT_THAT(outcome.err, HasSubstr(name)) << option;
            EXPECT_THAT(outcome.err, testing::AnyOf(HasSubstr("is a folder"), HasSubstr("is a socket"),
                                                    HasSubstr("names no file")))
                << option;
        }
    }
    EXPECT_THAT(names_in(folder / "folder"), testing::IsEmpty());
}

/// A store is a file: SQLite would leave a journal next to a device.
TEST(OutputFile, ThatIsAStoreIsNoDeviceAndNoFolder) {
    const Folder folder;
    fs::create_directory(folder / "there");
    fs::create_directory(folder / "there" / "folder");
    ASSERT_EQ(mkfifo((folder / "there" / "pipe").c_str(), 0600), 0);
    std::vector<std::string> names = {"folder", "pipe"};
    if (mknod((folder / "there" / "zero").c_str(), S_IFCHR | 0666, makedev(1, 5)) == 0)
        names.emplace_back("zero");
    int stores = 0;
    for (const std::string& command : listed_commands(folder)) {
        for (const ListedOption& option : listed_options(command, folder)) {
            if (option.name != "--store") continue;
            ++stores;
            for (const std::string& name : names) {
                Arguments words = {command};
                words.insert(words.end(), printing.at(command).begin(), printing.at(command).end());
                std::erase(words, "--store");
                std::erase_if(words, [](const std::string& word) { return word.ends_with(".db"); });
                words.insert(words.end(), {"--store", "there/" + name});
                const Outcome outcome = run(words, folder);
                EXPECT_EQ(outcome.exit_code, 2) << command << name;
                EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
                EXPECT_THAT(outcome.err, HasSubstr("there/" + name)) << command;
                EXPECT_THAT(names_in(folder / "there"), testing::ElementsAreArray(names)) << command;
            }
        }
    }
    EXPECT_GE(stores, 4);
}

/// Where a file may have 512 bytes and no more: the old one stays, nothing else is left.
TEST(OutputFile, OnAFullDiskLeavesTheOldOneAndNoOther) {
    const Folder folder;
    fill(folder);
    fs::create_directory(folder / "there");
    for (const auto& [option, writer] : writers) {
        if (!writer.is_text || option == "fields --write") continue;  // that one is shorter
        folder.write("there/file", "as it was\n");
        const Outcome outcome = run_in_shell("trap '' XFSZ; ulimit -f 1; \"$0\" \"$@\" >/dev/null",
                                             writing(option, "there/file"), folder);
        EXPECT_EQ(outcome.exit_code, 2) << option;
        EXPECT_EQ(lines_of(outcome.err).size(), 1U) << option << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("there/file: cannot be written: File too large")) << option;
        EXPECT_EQ(text_of(folder / "there" / "file"), "as it was\n") << option;
        EXPECT_THAT(names_in(folder / "there"), testing::ElementsAre("file")) << option;
    }
}

TEST(OutputFile, ThatIsNotFinishedIsRemovedAtCtrlC) {
    const Folder folder;
    fs::create_directory(folder / "there");
    Process process(program_path,
                    {"caches", "--queries", "1000000", "--shape", "cube8", "--write", "there/file"}, folder);
    for (int i = 0; i < 600 && names_in(folder / "there").empty() && !process.has_ended(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_THAT(names_in(folder / "there"), testing::ElementsAre(HasSubstr("file.")));
    process.send(SIGINT);
    EXPECT_EQ(process.wait().signal, SIGINT);
    EXPECT_THAT(names_in(folder / "there"), testing::IsEmpty());
}

}  // namespace
}  // namespace edgewise::cli_test
