// SPDX-License-Identifier: MIT
//
// Common code of the programs of golden figures: a file with one row for each thing that was computed ("what
// figures"), the comparison of computed rows with the file, and the command line.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace edgewise::golden {

/// What was computed -> its figures, as text.
using Rows = std::map<std::string, std::string>;

/// One program of golden figures.
struct Program {
    std::string name;     ///< as it is called
    std::string usage;    ///< behind the name
    std::string summary;  ///< behind "3 of 40 "
    int words = 1;        ///< of a row's end that are figures
    std::function<Rows()> compute;
    double slack = 0;           ///< numbers may differ by this share
    std::string left_out = {};  ///< rows that begin with this are not compared; empty: all are
};

/// Returns true if all words are equal, or numbers that differ by no more than the slack.
[[nodiscard]] inline bool are_near(const std::string& found, const std::string& expected, double slack) {
    std::istringstream ours(found), theirs(expected);
    std::string a, b;
    while (ours >> a) {
        if (!(theirs >> b)) return false;
        if (a != b && (slack == 0 || std::abs(std::stod(a) - std::stod(b)) > slack * std::stod(b)))
            return false;
    }
    return !(theirs >> b);
}

/// Place of the blank before the last `words` words; npos if the row has fewer words.
[[nodiscard]] inline std::size_t figures_at(std::string_view row, int words) {
    std::size_t at = row.size();
    for (; words > 0 && at != std::string_view::npos && at > 0; --words) at = row.rfind(' ', at - 1);
    return words == 0 ? at : std::string_view::npos;
}

[[nodiscard]] inline Rows read_rows(const std::string& file, int words) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(file + ": cannot be read");
    Rows rows;
    for (std::string row; std::getline(stream, row);) {
        const std::size_t at = figures_at(row, words);
        if (at == std::string::npos) throw std::runtime_error(file + ": not a row of figures: " + row);
        rows[row.substr(0, at)] = row.substr(at + 1);
    }
    return rows;
}

inline void write_rows(std::FILE* to, const Rows& rows) {
    for (const auto& [what, figures] : rows) fmt::print(to, "{} {}\n", what, figures);
}

[[nodiscard]] inline int update(const std::string& file, const Rows& rows) {
    std::FILE* const stream = std::fopen(file.c_str(), "w");
    if (!stream) throw std::runtime_error(file + ": cannot be written");
    write_rows(stream, rows);
    return std::fclose(stream);
}

/// Number of rows that differ, are missing or are too many; prints each. some: the file may have more rows.
[[nodiscard]] inline int differences(const Program& program, const Rows& found, const Rows& expected,
                                     bool some) {
    int count = 0;
    const auto is_left_out = [&](const std::string& what) {
        return !program.left_out.empty() && what.starts_with(program.left_out);
    };
    for (const auto& [what, figures] : found) {
        const auto place = expected.find(what);
        const bool known = place != expected.end();
        if (is_left_out(what) || (known && are_near(figures, place->second, program.slack))) continue;
        ++count;
        fmt::print(stderr, "{}: {} here, {} in the file\n", what, figures, known ? place->second : "missing");
    }
    for (const auto& [what, figures] : expected) {
        if (some || found.count(what) || is_left_out(what)) continue;
        ++count;
        fmt::print(stderr, "{}: in the file, but not in this program\n", what);
    }
    return count;
}

/// Compares with the file, or writes it. Returns the exit code: 0 no difference, 1 differences, 2 wrong
/// usage.
[[nodiscard]] inline int run(const Program& program, std::vector<std::string> arguments) {
    const bool some = std::erase(arguments, "--some") > 0, updates = std::erase(arguments, "--update") > 0;
    if (arguments.size() != 1 || arguments[0].starts_with("--") || (some && updates)) {
        fmt::print(stderr, "usage: {} {}\n", program.name, program.usage);
        return 2;
    }
    const Rows found = program.compute();
    if (updates) return update(arguments[0], found);
    const int count = differences(program, found, read_rows(arguments[0], program.words), some);
    fmt::print("{} of {} {}\n", count, found.size(), program.summary);
    if (count > 0) fmt::print(stderr, "if this was meant: {} --update {}\n", program.name, arguments[0]);
    return count > 0 ? 1 : 0;
}

/// Exit code of main: that of the body, or 2 with one line that says what failed.
[[nodiscard]] inline int run_or_say_why(const Program& program, const std::function<int()>& body) {
    try {
        return body();
    } catch (const std::exception& problem) {
        fmt::print(stderr, "{}: {}\n", program.name, problem.what());
        return 2;
    }
}

}  // namespace edgewise::golden
