// SPDX-License-Identifier: MIT
//
// A file that a command is to write arrives, or the command says so and ends with 2, whatever is already at
// that path.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <chrono>
#include <thread>

#include "cli_paths.hpp"
#include "commands.hpp"

namespace edgewise::cli_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// An option that names a file to be written.
struct Writer {
    Arguments arguments;  ///< without the file, which follows the option
    bool is_text = true;  ///< written through to a pipe, and longer than 512 bytes
    Arguments more = {};  ///< after the file
};

const std::map<std::string, Writer> writers = {
    {"export --out", {{"export", "s.db"}}},
    {"caches --out", {{"caches", "--shape", "cube8", "--queries", "200"}}},
    {"fields --out",
     {{"fields", "--shape", "cube8", "--queries", "50", "--rounds", "9", "--checked", "5"}, true}},
    {"fields --svg", {{"fields", "--shape", "cube8", "--queries", "50", "--rounds", "9", "--checked", "5"}}},
    {"campaign --state",
     {{"campaign", "--pairs", "50", "--families", "random", "--shapes", "cube8", "--layouts", "aos_f64"},
      false}},
    {"campaign --failures",
     {{"campaign", "--pairs", "50", "--families", "random", "--shapes", "cube8", "--layouts", "aos_f64"},
      false}},
    {"merge --out", {{"merge", "s.db"}, false}},
    {"record --out", {{"record", "bullet-stack", "--seconds", "0.1"}}},
    {"advise budget --out",
     {{"advise", "budget", "--shape", "sphere38", "--vertices", "20", "--table", "aos_f64"}}},
    {"bench gate",
     {{"bench", "gate", "--layouts", "aos_f64", "--rounds", "9", "--queries", "50"}, true, {"--write"}}},
    {"draw heat --svg", {{"draw", "heat", "--shape", "cube8", "--queries", "20"}}},
    {"draw layout --svg", {{"draw", "layout", "aos_f64", "--shape", "tetra4"}}},
};

Arguments writing(const std::string& option, const std::string& file) {
    const Writer& writer = writers.at(option);
    Arguments words = writer.arguments;
    if (const std::size_t dashes = option.find("--"); dashes != option.npos)
        words.push_back(option.substr(dashes));
    words.push_back(file);
    return with(words, writer.more);
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
                Arguments words = called(command, printing().at(command));
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
        // The file of `fields --out` is shorter; `export` reads a store and `record` its engine's
        // output, which are larger files of their own.
        const bool has_others = option == "export --out" || option == "record --out";
        if (!writer.is_text || option == "fields --out" || has_others) continue;
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
                    {"caches", "--queries", "1000000", "--shape", "cube8", "--out", "there/file"}, folder);
    for (int i = 0; i < 6000 && names_in(folder / "there").empty() && !process.has_ended(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_THAT(names_in(folder / "there"), testing::ElementsAre(HasSubstr("file.")));
    process.send(SIGINT);
    EXPECT_EQ(process.wait().signal, SIGINT);
    EXPECT_THAT(names_in(folder / "there"), testing::IsEmpty());
}

}  // namespace
}  // namespace edgewise::cli_test
