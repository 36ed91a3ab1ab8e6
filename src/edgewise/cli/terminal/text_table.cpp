// SPDX-License-Identifier: MIT
#include "edgewise/cli/terminal/text_table.hpp"

#include <algorithm>
#include <cassert>
#include <sstream>

#include "edgewise/input/shown_text.hpp"

namespace edgewise::cli {

namespace {

constexpr std::size_t between = 2;      ///< blanks
constexpr std::size_t least_last = 24;  ///< characters, of a folded column

/// What is seen of UTF-8: continuation bytes take no column.
std::size_t columns_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string blanks(std::size_t count) { return std::string(count, ' '); }

}  // namespace

std::string folded(const std::string& text, std::size_t width, std::size_t indent) {
    std::istringstream words(text);
    std::string result;
    std::size_t used = 0;
    for (std::string word; words >> word;) {
        const std::size_t needed = columns_of(word);
        if (used == 0) {
            used = needed;
        } else if (used + 1 + needed <= width) {
            result += ' ';
            used += 1 + needed;
        } else {
            result += '\n' + blanks(indent);
            used = needed;
        }
        result += word;
    }
    return result;
}

TextTable::TextTable(std::vector<std::string> titles) {
    for (std::string& title : titles) {
        numbers_.push_back(title.starts_with("#"));
        if (numbers_.back()) title.erase(0, 1);
    }
    rows_.push_back(std::move(titles));
}

void TextTable::add(std::vector<std::string> row) {
    assert(row.size() == numbers_.size());
    for (std::string& cell : row) cell = input::shown_line(cell);
    rows_.push_back(std::move(row));
}

std::string TextTable::text(std::size_t width) const {
    const std::size_t last = numbers_.size() - 1;
    std::vector<std::size_t> widths(numbers_.size());
    for (const auto& row : rows_) {
        for (std::size_t i = 0; i <= last; ++i) widths[i] = std::max(widths[i], columns_of(row[i]));
    }
    std::size_t start = 0;  // of the last column
    for (std::size_t i = 0; i < last; ++i) start += widths[i] + between;
    const std::size_t room = std::max(start + least_last, width);
    std::string result;
    for (const auto& row : rows_) {
        for (std::size_t i = 0; i <= last; ++i) {
            const std::string fill = blanks(widths[i] - columns_of(row[i]));
            if (i == last && !numbers_[i]) {
                result += folded(row[i], room - start, start);
            } else {
                result += numbers_[i] ? fill + row[i] : row[i] + fill;
            }
            if (i < last) result += blanks(between);
        }
        while (result.ends_with(' ')) result.pop_back();
        result += '\n';
    }
    return result;
}

}  // namespace edgewise::cli
