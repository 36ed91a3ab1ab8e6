// SPDX-License-Identifier: MIT
#include "edgewise/scene/dumps/dump_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>

#include "edgewise/input/known_names.hpp"

namespace edgewise::scene {

namespace {

constexpr std::string_view blanks = " \t\r\n";

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// A text that stands in a message.
std::string shown(std::string_view text) {
    constexpr std::size_t longest = 30;
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    text = text.substr(begin, std::min(longest, text.find('\n', begin) - begin));
    return on_one_line(text);
}

}  // namespace

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
