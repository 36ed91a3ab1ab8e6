// SPDX-License-Identifier: MIT
//
// Where the functions and classes of a C++ file begin and end, found by braces alone. Lambdas and local
// classes count as lines of the function they stand in; member functions of a class at file level count for
// themselves.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace edgewise::house {

struct Span {
    std::size_t first = 0, last = 0;  ///< lines, from 1: of the name, and of the closing brace
};

[[nodiscard]] std::vector<Span> function_spans(const std::vector<std::string>& lines);
[[nodiscard]] std::vector<Span> class_spans(const std::vector<std::string>& lines);

/// The text with comments, literals and preprocessor lines blanked out; line breaks stay.
[[nodiscard]] std::string bare_code(const std::vector<std::string>& lines);

}  // namespace edgewise::house
