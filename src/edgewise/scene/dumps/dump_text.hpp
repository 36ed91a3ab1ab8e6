// SPDX-License-Identifier: MIT
//
// Reading of texts that people paste: numbers between separators, words in a known order, quotes of a mail.
// Everything is used up or refused.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/result.hpp"

namespace edgewise::scene {

/// The number that the text begins with, which is removed; nothing where none stands there, or one that is
/// not finite.
[[nodiscard]] std::optional<double> take_number(std::string_view& text);

/// All the numbers of a text that holds nothing else but blanks, brackets, and at most one comma or semicolon
/// between two of them. The error names what is no number.
[[nodiscard]] Result<std::vector<double>> numbers_in(std::string_view text);

/// Without the '>' before quoted lines.
[[nodiscard]] std::string without_quotes(std::string_view text);

/// A text read word by word, blanks between them passed over.
class WordReader {
  public:
    explicit WordReader(std::string_view text) : rest_(text) {}

    /// Whether the word comes next; then it is passed.
    bool take(std::string_view word);
    /// These words, apart by blanks, one after the other; # is any name. False at the first that is missing.
    bool take_all(std::string_view words);
    [[nodiscard]] std::optional<double> number();
    [[nodiscard]] bool at_end();

    /// The beginning of what is left, for a message.
    [[nodiscard]] std::string next();

  private:
    void skip_blanks();
    bool take_name();

    std::string_view rest_;
};

}  // namespace edgewise::scene
