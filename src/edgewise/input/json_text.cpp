// SPDX-License-Identifier: MIT
#include "edgewise/input/json_text.hpp"

#include <algorithm>

namespace edgewise::input {

std::size_t nesting_of(std::string_view text) {
    std::size_t depth = 0, deepest = 0;
    bool in_text = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_text) {
            if (c == '\\') ++i;
            in_text = c != '"';
        } else if (c == '"') {
            in_text = true;
        } else if (c == '[' || c == '{') {
            deepest = std::max(deepest, ++depth);
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return deepest;
}

std::string place_in(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
    const auto lines = std::ranges::count(before, '\n');
    const std::size_t column = before.size() - (lines > 0 ? before.rfind('\n') + 1 : 0) + 1;
    return (lines > 0 ? "line " + std::to_string(lines + 1) + ", " : "") + "column " + std::to_string(column);
}

}  // namespace edgewise::input
