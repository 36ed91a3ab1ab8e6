// SPDX-License-Identifier: MIT
//
// What all texts that people paste have in common: numbers between words, quotes of a mail, comments of code.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace edgewise::scene {

/// Numbers as they follow each other from `from` on, with blanks, commas, brackets, semicolons and `<<`
/// between them, at most `most`; a letter ends them.
[[nodiscard]] std::vector<double> numbers_from(std::string_view text, std::size_t from, std::size_t most);

/// Without the '>' before quoted lines, and without what follows // (or # in Python) on a line.
[[nodiscard]] std::string without_quotes_and_comments(std::string_view text);

/// The name that ends before `at`: "trans1" of "trans1.rotation()" at the dot. Empty where none does.
[[nodiscard]] std::string name_before(std::string_view text, std::size_t at);

}  // namespace edgewise::scene
