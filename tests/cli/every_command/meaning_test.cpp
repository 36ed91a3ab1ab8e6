// SPDX-License-Identifier: MIT
//
// One word means one thing in every command: a body is named in one way, and an option has one text. The
// manual page, the table of options and the completions of shells are read from the same commands.
#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>

#include "cli_paths.hpp"
#include "commands.hpp"

namespace edgewise::cli_test {
namespace {

using testing::HasSubstr;

/// The words with this body instead of those that they name.
Arguments with_body(Arguments words, const std::string& option, const std::string& body) {
    for (auto word = words.begin(); word != words.end();)
        word = *word == option || *word == "--shapes" ? words.erase(word, word + 2) : word + 1;
    return with(words, {option, body});
}

/// Commands with a body: those that take seconds are run, the others only read their command line.
TEST(Body, IsABuiltInNameOrAMeshFileInEveryCommand) {
    const Folder folder;
    const NoOtherPrograms none;
    fill(folder);
    folder.write("box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    int commands = 0;
    for (const std::string& command : listed_commands(folder)) {
        for (const ListedOption& option : listed_options(command, folder)) {
            if (option.type != "NAME|FILE" || option.name.size() < 4) continue;  // --a and --b are judge's
            EXPECT_EQ(option.name, "--shape") << command;
            ++commands;
            for (const std::string body : {"cube8", "box.obj"}) {
                std::filesystem::remove_all(folder /
                                            "reports");  // the progress of a campaign with another body
                Arguments words = with_body(called(command, printing().at(command)), option.name, body);
                if (command == "advise") words.insert(words.begin(), "--parse-only");
                const Outcome outcome = run(words, folder);
                EXPECT_NE(outcome.exit_code, 2) << command << " " << body << ": " << outcome.err;
            }
            const Outcome unknown =
                run(with_body(called(command, printing().at(command)), option.name, "nope.obj"), folder);
            if (command != "advise") {
                EXPECT_EQ(unknown.exit_code, 2) << command;
                EXPECT_THAT(unknown.err, HasSubstr("nope.obj")) << command;
            }
        }
    }
    EXPECT_GE(commands, 16);
    for (const char* second : {"box.obj", "cube8"}) {
        const Outcome outcome = run(
            {"judge", "--a", "cube8", "--b", second, "--pose-b", "5,0,0", "--layouts", "aos_f64", "--json"},
            folder);
        EXPECT_NE(outcome.exit_code, 2) << second << outcome.err;
    }
}

TEST(Body, OfAFileIsThatOfAnOlderOptionToo) {
    const Folder folder;
    folder.write("box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    const Arguments bytes = {"bytes", "--layouts", "aos_f64"};
    EXPECT_EQ(run(with_body(bytes, "--mesh", "box.obj"), folder).out,
              run(with_body(bytes, "--shape", "box.obj"), folder).out);
}

/// A row of the table of options.
struct Row {
    std::string value, meaning, commands;
};

std::multimap<std::string, Row> options_table() {
    std::multimap<std::string, Row> rows;
    for (const std::string& line : lines_of(run({"--print", "options"}, Folder()).out)) {
        if (!line.starts_with("| `")) continue;
        std::vector<std::string> cells = {""};
        for (std::size_t i = 2; i < line.size(); ++i) {
            const bool is_end = line.compare(i, 3, " | ") == 0 || (i + 2 == line.size());
            if (!is_end) {
                cells.back() += line[i];
                continue;
            }
            cells.emplace_back();
            i += 2;
        }
        rows.insert(
            {cells[0].substr(1, cells[0].find_first_of(",`", 1) - 1), {cells[1], cells[2], cells[3]}});
    }
    return rows;
}

/// The words that all texts of an option have in common, if it has several.
const std::map<std::string, std::string> common_words = {
    {"--bodies", "how many bodies"},
    {"--out", " to write: "},
    {"--peers", "these other libraries"},
    {"--scene", "scene: "},
    {"--shape", "built in (edgewise list shapes), or"},
    {"--scenes", "only these scenes"},
    {"--slack", "a time may become longer by this part of itself"},
    {"--steps", "steps"},
    {"--store", "store (an SQLite file): "},
    {"--vertices", "how many vertices"},
};

TEST(Option, OfOneNameMeansTheSameInEveryCommand) {
    const auto rows = options_table();
    EXPECT_GT(rows.size(), 60U);
    for (const auto& [name, row] : rows) {
        const auto common = common_words.find(name);
        const auto& first = rows.find(name)->second;
        if (common == common_words.end()) {
            EXPECT_EQ(row.meaning, first.meaning)
                << name << " of " << first.commands << " and " << row.commands;
        } else {
            EXPECT_THAT(row.meaning, HasSubstr(common->second)) << name << " of " << row.commands;
        }
    }
    for (const char* name : {"--svg", "--table", "--layouts", "--seed", "--as-stored", "--shape"})
        EXPECT_GT(rows.count(name), 0U) << name;
    EXPECT_EQ(rows.find("--svg")->second.value, "FILE");
}

TEST(Manual, TableOfOptionsIsUpToDate) {
    EXPECT_EQ(run({"--print", "options"}, Folder()).out, text_of(options_file))
        << "write it again: build/release/edgewise --print options > docs/options.md";
}

TEST(Manual, PageHasEveryCommandAndIsRoff) {
    const Folder folder;
    folder.write("edgewise.1", run({"--print", "man"}, folder).out);
    const std::string page = text_of(folder / "edgewise.1");
    for (const char* section : {"NAME", "SYNOPSIS", "DESCRIPTION", "COMMANDS", "EXIT STATUS"})
        EXPECT_THAT(page, HasSubstr(std::string(".SH ") + section + "\n"));
    for (const std::string& command : listed_commands(folder))
        EXPECT_THAT(page, HasSubstr(".SS " + command + "\n"));
    const Outcome checked = run_in_shell(
        "command -v man >/dev/null || exit 0; LC_ALL=C MANWIDTH=80 man -l --warnings edgewise.1 2>&1 >/dev/null | head -5",
        {}, folder);
    EXPECT_EQ(checked.out, "");
}

/// What bash offers at the end of these words.
std::set<std::string> completions(const std::string& words, const Folder& folder) {
    const Outcome outcome =
        run_in_shell("LC_ALL=C bash -c 'source edgewise.bash; COMP_WORDS=(" + words +
                         "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _edgewise; echo \"${COMPREPLY[@]}\"'",
                     {}, folder);
    EXPECT_EQ(outcome.err, "");
    std::istringstream text(outcome.out);
    std::set<std::string> offered;
    for (std::string word; text >> word;) offered.insert(word);
    return offered;
}

TEST(Manual, CompletionsKnowCommandsAndOptions) {
    const Folder folder;
    for (const std::string shell : {"bash", "zsh", "fish"}) {
        folder.write("edgewise." + shell, run({"--print", shell}, folder).out);
        const Outcome checked = run_in_shell(
            "command -v " + shell + " >/dev/null || exit 0; " + shell + " -n edgewise." + shell, {}, folder);
        EXPECT_EQ(checked.exit_code, 0) << checked.err;
    }
    EXPECT_EQ(completions("edgewise adv", folder), std::set<std::string>{"advise"});
    EXPECT_EQ(completions("edgewise bench \"\"", folder),
              (std::set<std::string>{"calibrate", "crosscheck", "effort", "gate", "model", "scaling"}));
    EXPECT_EQ(completions("edgewise advise --bodies 3 budget --tol", folder),
              std::set<std::string>{"--tolerance"});
    EXPECT_EQ(completions("edgewise bytes --shape cu", folder), std::set<std::string>{}) << "a file, by bash";
    EXPECT_EQ(completions("edgewise advise --sha", folder),
              (std::set<std::string>{"--shape", "--shared-tables"}));
}

}  // namespace
}  // namespace edgewise::cli_test
