// SPDX-License-Identifier: MIT
#include "edgewise/scene/dumps/dump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "edgewise/input/json_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/nearest_rotation.hpp"

namespace edgewise::scene {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

constexpr const char* what_is_read =
    "judge reads a case line of JSON, a message of FCL or Drake (Shape 1, X_FS1, Shape 2, X_FS2), or body files "
    "(--a, --b, --pose-a, --pose-b); edgewise judge --template prints a case to fill in";

/// Why a text of several lines is no case, if its first line is one.
std::string behind_first_case(std::string_view text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const bool more = text.find_first_not_of(" \t\r\n", end) != text.npos;
    if (!more || !input::parse_json(text.substr(0, end))) return {};
    return "; judge takes one case, and more stands behind the first line (edgewise query answers all of a file)";
}

constexpr std::string_view blanks = " \t\r\n";

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Shortens a text for use in a message.
std::string shown(std::string_view text) {
    constexpr std::size_t longest = 30;
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    text = text.substr(begin, std::min(longest, text.find('\n', begin) - begin));
    return on_one_line(text);
}

}  // namespace

Result<PastedPair> read_pasted(std::string_view text, const std::string& where) {
    using Pasted = Result<PastedPair>;
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == text.npos) return Pasted::failure(fmt::format("{}: nothing in it; {}", where, what_is_read));
    if (text[begin] == '{' || text[begin] == '[') {
        text.remove_prefix(begin);
        std::string id;
        auto given = parse_case(text, where, id);
        if (!given) return Pasted::failure(given.error + behind_first_case(text));
        return Pasted::success({*std::move(given.value), "case line", std::nullopt}, given.warning);
    }
    if (text.find("X_FS1") != text.npos || text.find("Shape 1") != text.npos)
        return read_fcl_dump(text, where);
    return Pasted::failure(fmt::format("{}: is none of what is read; {}", where, what_is_read));
}

Result<Pose> pose_from_rows(const std::vector<double>& m, const std::string& name) {
    using Failure = Result<Pose>;
    if (m.size() != 12 && m.size() != 16)
        return Failure::failure(fmt::format("{} has {} numbers, wants 12 or 16", name, m.size()));
    const bool affine = m.size() == 12 || (m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1);
    if (!affine) return Failure::failure(fmt::format("the fourth row of {} is not 0 0 0 1", name));
    Mat3d given;
    given << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
    const auto rotation = nearest_rotation(given);
    if (!rotation) return Failure::failure(fmt::format("the matrix of {} {}", name, rotation.error));
    std::string note;
    if (!rotation.warning.empty()) note = fmt::format("the matrix of {} {}", name, rotation.warning);
    return Result<Pose>::success({*rotation, {m[3], m[7], m[11]}}, note);
}

std::optional<double> take_number(std::string_view& text) {
    std::string_view digits = text;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
    double value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    return value;
}

Result<std::vector<double>> numbers_in(std::string_view text) {
    using Numbers = Result<std::vector<double>>;
    constexpr std::string_view separators = " \t\r\n,;[]";
    std::vector<double> numbers;
    for (;;) {
        const std::size_t next = std::min(text.find_first_not_of(separators), text.size());
        const std::string_view between = text.substr(0, next);
        const auto commas = std::ranges::count_if(between, [](char c) { return c == ',' || c == ';'; });
        const bool apart = numbers.empty() || next > 0 || next == text.size();
        if (commas > (numbers.empty() ? 0 : 1) || !apart)
            return Numbers::failure(fmt::format("'{}' has no number where one is wanted", shown(text)));
        text.remove_prefix(next);
        if (text.empty()) return Numbers::success(std::move(numbers));
        const std::string_view before = text;
        const auto number = take_number(text);
        if (!number) return Numbers::failure(fmt::format("'{}' is no number", shown(before)));
        numbers.push_back(*number);
    }
}

std::string without_quotes(std::string_view text) {
    std::istringstream lines{std::string(text)};
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        std::size_t start = line.find_first_not_of(" \t");
        while (start != line.npos && line[start] == '>') start = line.find_first_not_of(" \t", start + 1);
        result += (start == line.npos ? "" : line.substr(start)) + "\n";
    }
    return result;
}

void WordReader::skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
}

bool WordReader::take(std::string_view word) {
    skip_blanks();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
}

bool WordReader::take_name() {
    skip_blanks();
    const auto end = std::ranges::find_if_not(rest_, is_word);
    const auto size = static_cast<std::size_t>(end - rest_.begin());
    rest_.remove_prefix(size);
    return size > 0;
}

bool WordReader::take_all(std::string_view words) {
    for (WordReader wanted(words); !wanted.at_end();) {
        const std::string_view word = wanted.rest_.substr(0, wanted.rest_.find(' '));
        if (!(word == "#" ? take_name() : take(word))) return false;
        wanted.rest_.remove_prefix(word.size());
    }
    return true;
}

std::optional<double> WordReader::number() {
    skip_blanks();
    return take_number(rest_);
}

bool WordReader::at_end() {
    skip_blanks();
    return rest_.empty();
}

std::string WordReader::next() { return shown(rest_); }

}  // namespace edgewise::scene
