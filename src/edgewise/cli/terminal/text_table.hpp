// SPDX-License-Identifier: MIT
//
// A table for a terminal: columns as wide as what stands in them, numbers flush right, and the last column
// folded where the line would be too long.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace edgewise::cli {

inline constexpr std::size_t widest_line = 100;  ///< characters

class TextTable {
  public:
    /// A title that begins with '#' is of a column of numbers.
    explicit TextTable(std::vector<std::string> titles);

    /// As many cells as titles.
    void add(std::vector<std::string> row);

    /// Lines of at most `width` characters, as far as all columns but the last leave room for words.
    [[nodiscard]] std::string text(std::size_t width = widest_line) const;

  private:
    std::vector<std::vector<std::string>> rows_;  ///< the titles first
    std::vector<bool> numbers_;
};

/// Text in lines of at most `width` characters, broken at blanks; before every line but the first stand
/// `indent` blanks more. A word that is longer stays whole.
[[nodiscard]] std::string folded(const std::string& text, std::size_t width, std::size_t indent = 0);

}  // namespace edgewise::cli
