// SPDX-License-Identifier: MIT
//
// golden_instructions VALGRIND PLAIN TUNED [--update] FILE
//
// Instructions per query, counted by Callgrind, so that a busy machine does not change them. PLAIN and TUNED
// are query_counts.cpp as a user compiles it (-O2) and with the program's own flags for query loops. Compares
// with the counts in the file, with a slack of 2 %: more is a loss, and less is a gain that the file should
// hold. Each compiler has its own file. Without one, the exit code is 77, which skips the test.
#include <fmt/core.h>

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>

#include "../golden_main.hpp"
#include "program.hpp"

namespace edgewise {
namespace {

constexpr double slack = 0.02;
constexpr int skipped = 77;

/// Rest of the line after `mark`; empty if there is none.
std::string behind(const std::string& mark, const std::string& text) {
    const std::size_t at = text.find(mark);
    if (at == std::string::npos) return {};
    return text.substr(at + mark.size(), text.find('\n', at) - at - mark.size());
}

/// A dump's label ends in its number of queries.
void add_row(golden::Rows& rows, const std::string& flavour, const std::string& dump) {
    const std::string label = behind("desc: Trigger: Client Request: ", dump);
    if (label.empty()) return;
    const std::size_t blank = label.rfind(' ');
    const double instructions = std::stod(behind("totals: ", dump));
    rows[flavour + " " + label.substr(0, blank)] =
        fmt::format("{:.1f}", instructions / std::stod(label.substr(blank)));
}

void add_counts(golden::Rows& rows, const std::string& valgrind, const std::string& flavour,
                const std::string& program) {
    const cli_test::Folder folder;
    const cli_test::Outcome outcome =
        cli_test::Process(valgrind,
                          {"--tool=callgrind", "--instr-atstart=no",
                           "--callgrind-out-file=" + (folder / "counts").string(), program},
                          folder)
            .wait();
    if (outcome.exit_code != 0) throw std::runtime_error(program + ": " + outcome.err);
    const std::size_t before = rows.size();
    for (const auto& file : std::filesystem::directory_iterator(folder.path()))
        add_row(rows, flavour, cli_test::text_of(file.path()));
    if (rows.size() == before) throw std::runtime_error(program + ": Callgrind dumped no counts");
}

int run(const std::vector<std::string>& words) {
    if (words.size() < 5 || words.size() > 6) {
        fmt::print(stderr, "usage: golden_instructions VALGRIND PLAIN TUNED [--update] FILE\n");
        return 2;
    }
    const std::string command = fmt::format("{} {} {} {}", words[0], words[1], words[2], words[3]);
    if (words.size() == 5 && !std::filesystem::exists(words[4])) {
        fmt::print("skipped: no counts of this compiler; to write them: {} --update {}\n", command, words[4]);
        return skipped;
    }
    const auto rows = [&] {
        golden::Rows all;
        add_counts(all, words[1], "plain", std::filesystem::absolute(words[2]));
        add_counts(all, words[1], "tuned", std::filesystem::absolute(words[3]));
        return all;
    };
    const std::string summary = fmt::format("counts differ by more than {:.0f} %", 100 * slack);
    return golden::run({command, "[--update] FILE", summary, 1, rows, slack},
                       {words.begin() + 4, words.end()});
}

}  // namespace
}  // namespace edgewise

int main(int count, char** values) {
    return edgewise::golden::run_or_say_why({"golden_instructions", "", "", 1, {}}, [&] {
        return edgewise::run({values, values + count});
    });
}
