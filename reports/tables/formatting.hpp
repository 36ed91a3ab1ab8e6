// SPDX-License-Identifier: MIT
//
// Numbers and text for people: how a figure is written, and how text is made safe for HTML, Markdown and
// names of files.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace edgewise::reports {

inline constexpr std::size_t widest_line = 100;  ///< characters, of what is printed on a terminal
inline constexpr double kibibyte = 1024, mebibyte = 1024 * kibibyte;

/// At most three or four significant digits, by unit: "168", "12.4", "3.1e-16", "0" only for exactly 0.
[[nodiscard]] std::string number_text(double value, const std::string& unit = {});
/// Returns the text with each of the given characters replaced.
[[nodiscard]] std::string replaced(const std::string& text, const std::map<char, const char*>& by);
[[nodiscard]] std::string html_text(const std::string& text);      ///< escapes & < > " '
[[nodiscard]] std::string markdown_text(const std::string& text);  ///< one line; escapes | and <
[[nodiscard]] std::string in_words(std::string name);              ///< "face_planes" -> "face planes"
/// Adds `part` to a list in one text.
void append(std::string& list, const std::string& part, const char* separator = ", ");
/// Returns a name for a file: the letters, digits, '_' and '-' of `name`, other bytes as '_'; a long name
/// becomes its beginning and a hash.
[[nodiscard]] std::string file_name_of(std::string name);
/// Returns a file name that is not yet in the set, changed if another name has it already.
[[nodiscard]] std::string file_name_of(const std::string& name, const std::set<std::string>& taken);
/// Distinct texts and their places from 0, in order of appearance.
class DistinctTexts {
  public:
    std::size_t place(const std::string& text) {
        const auto [at, is_new] = places_.emplace(text, texts_.size());
        if (is_new) texts_.push_back(text);
        return at->second;
    }
    [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

  private:
    std::map<std::string, std::size_t> places_;
    std::vector<std::string> texts_;
};

/// Columns that UTF-8 takes on a terminal.
[[nodiscard]] std::size_t shown_width(const std::string& text);
/// Text in lines of at most `width` characters, broken at blanks; every line except the first begins
/// with `indent` more blanks. A word that is longer stays whole.
[[nodiscard]] std::string wrapped(const std::string& text, std::size_t width = widest_line,
                                  std::size_t indent = 0);
/// "1 cell", "2 cells"; `many`: a plural that is not made with s.
[[nodiscard]] std::string plural(std::size_t count, const std::string& noun, const std::string& many = {});

}  // namespace edgewise::reports
