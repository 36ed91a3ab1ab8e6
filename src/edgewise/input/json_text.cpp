// SPDX-License-Identifier: MIT
#include "edgewise/input/json_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "edgewise/input/known_names.hpp"

namespace edgewise::input {

namespace {

struct Brackets {
    std::size_t open = 0, deepest = 0;
    bool in_text = false;  ///< at the end
};

Brackets brackets_in(std::string_view text) {
    Brackets result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (result.in_text) {
            if (c == '\\') ++i;
            result.in_text = c != '"';
        } else if (c == '"') {
            result.in_text = true;
        } else if (c == '[' || c == '{') {
            result.deepest = std::max(result.deepest, ++result.open);
        } else if ((c == ']' || c == '}') && result.open > 0) {
            --result.open;
        }
    }
    return result;
}

/// "column 12", or "line 3, column 12" where that is not the first line; both count from 1.
std::string place_in(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
    const auto lines = std::ranges::count(before, '\n');
    const std::size_t column = before.size() - (lines > 0 ? before.rfind('\n') + 1 : 0) + 1;
    return (lines > 0 ? "line " + std::to_string(lines + 1) + ", " : "") + "column " + std::to_string(column);
}

}  // namespace

std::size_t nesting_of(std::string_view text) { return brackets_in(text).deepest; }

bool ends_inside(std::string_view text) {
    const Brackets found = brackets_in(text);
    return found.open > 0 || found.in_text;
}

std::string not_json_at(std::string_view text, std::size_t byte) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    std::size_t begin = std::min(byte > 0 ? byte - 1 : 0, text.size()), end = begin;
    while (begin > 0 && is_letter(text[begin - 1])) --begin;
    while (end < text.size() && is_letter(text[end])) ++end;
    const std::string_view word = text.substr(begin, end - begin);
    const bool no_number = std::ranges::any_of(std::array{"nan", "inf", "infinity"}, [&](const char* name) {
        return edits_between(word, name) == 0;  // whatever the case of its letters
    });
    return "not JSON at " + place_in(text, byte) + (no_number ? " (NaN and Infinity are not numbers)" : "");
}

void RepeatedMember::take(std::string name) {
    Object& object = objects_.back();
    object.last = name;
    if (object.names.insert(std::move(name)).second || !path_.empty()) return;
    for (const Object& outer : objects_) path_ += (path_.empty() ? "" : ".") + outer.last;
    path_ = path_.empty() ? "''" : on_one_line(path_);
}

std::string not_a_member(std::string_view name, std::string_view what,
                         const std::vector<std::string>& known) {
    return fmt::format("'{}' is not a member of {}{} known: {}", on_one_line(name), what,
                       did_you_mean(name, known), fmt::join(known, ", "));
}

}  // namespace edgewise::input
