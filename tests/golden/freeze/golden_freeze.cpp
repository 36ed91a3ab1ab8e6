// SPDX-License-Identifier: MIT
//
// golden_freeze [--update] FOLDER
//
// Checks that a change of the code changes nothing that users see: all help texts, lists and bytes as JSON,
// the report of a small store with its data, and the verdicts on every pair of the corpus. Compares them with
// the text files in FOLDER and shows a diff. If a change is meant, --update and commit the files with it.
#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "edgewise/bench/cell.hpp"
#include "frozen.hpp"

namespace edgewise::golden {

std::string hash_of(std::string_view text) { return bench::Fingerprint().add(text).hex(); }

std::string output_of(const cli_test::Arguments& arguments, const cli_test::Folder& folder) {
    const cli_test::Outcome outcome = cli_test::run(arguments, folder);
    if (outcome.exit_code == 0) return outcome.out;
    throw std::runtime_error(fmt::format("edgewise {}: {}", fmt::join(arguments, " "), outcome.err));
}

namespace {

Texts all_texts() {
    Texts texts;
    add_drawings(texts);
    add_listings(texts);
    add_report(texts);
    add_verdicts(texts);
    return texts;
}

void write(const Texts& texts, const std::filesystem::path& folder) {
    for (const auto& [name, text] : texts) {
        std::ofstream stream(folder / name, std::ios::binary);
        stream << text;
        if (!stream) throw std::runtime_error((folder / name).string() + ": cannot be written");
    }
}

/// Returns 0 if all texts are as in the folder; else prints a diff and returns 1.
int compare(const Texts& texts, const std::string& expected, const std::string& program) {
    const cli_test::Folder folder;
    const std::filesystem::path found = folder / "found";
    std::filesystem::create_directory(found);
    write(texts, found);
    const cli_test::Outcome diff =
        cli_test::Process("/usr/bin/env", {"diff", "-r", "-U0", expected, "found"}, folder).wait();
    if (diff.exit_code == 0) {
        fmt::print("{} texts are as they were\n", texts.size());
        return 0;
    }
    fmt::print(stderr, "{}{}if this was meant: {} --update {}\n", diff.out, diff.err, program, expected);
    return 1;
}

int run(const std::string& program, const std::vector<std::string>& arguments) {
    const bool updates = arguments.size() == 2 && arguments[0] == "--update";
    if (!updates && arguments.size() != 1) {
        fmt::print(stderr, "usage: golden_freeze [--update] FOLDER\n");
        return 2;
    }
    const std::string folder = std::filesystem::absolute(arguments.back());
    const Texts texts = all_texts();
    if (!updates) return compare(texts, folder, program);
    write(texts, folder);
    return 0;
}

}  // namespace
}  // namespace edgewise::golden

int main(int count, char** values) {
    try {
        return edgewise::golden::run(values[0], {values + 1, values + count});
    } catch (const std::exception& problem) {
        fmt::print(stderr, "golden_freeze: {}\n", problem.what());
        return 2;
    }
}
