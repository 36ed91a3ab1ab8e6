// SPDX-License-Identifier: MIT
#include "edgewise/scene/dumps/dump_text.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>

namespace edgewise::scene {

namespace {

constexpr std::string_view between = " \t\r\n,;()[]{}<";

bool begins_number(std::string_view text, std::size_t at) {
    if (text[at] == '+' || text[at] == '-') ++at;
    if (at < text.size() && text[at] == '.') ++at;
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

}  // namespace

std::vector<double> numbers_from(std::string_view text, std::size_t from, std::size_t most) {
    const std::string copy(text.substr(std::min(from, text.size())));
    std::vector<double> numbers;
    std::size_t at = 0;
    while (numbers.size() < most && at < copy.size()) {
        if (between.find(copy[at]) != between.npos) {
            ++at;
        } else if (begins_number(copy, at)) {
            char* end = nullptr;
            numbers.push_back(std::strtod(copy.c_str() + at, &end));
            at = static_cast<std::size_t>(end - copy.c_str());
            if (at < copy.size() && (copy[at] == 'f' || copy[at] == 'F')) ++at;  // 2.0f
        } else {
            break;
        }
    }
    return numbers;
}

std::string without_quotes_and_comments(std::string_view text) {
    std::istringstream lines{std::string(text)};
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        std::size_t start = line.find_first_not_of(" \t");
        while (start != line.npos && line[start] == '>') start = line.find_first_not_of(" \t", start + 1);
        line = start == line.npos ? "" : line.substr(start);
        const std::size_t comment = line.find("//");
        // "https://..." is none.
        if (comment != line.npos && (comment == 0 || line[comment - 1] != ':')) line.resize(comment);
        if (line.starts_with("#")) line.clear();
        result += line + "\n";
    }
    return result;
}

std::string name_before(std::string_view text, std::size_t at) {
    std::size_t begin = at;
    while (begin > 0 && is_word(text[begin - 1])) --begin;
    return std::string(text.substr(begin, at - begin));
}

}  // namespace edgewise::scene
