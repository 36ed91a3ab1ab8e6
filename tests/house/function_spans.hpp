// SPDX-License-Identifier: MIT
//
// Where the functions of a C++ file begin and end, found by braces alone. Lambdas and local classes count as
// lines of the function they stand in; member functions of a class at file level count for themselves.
#pragma once

#include <string>
#include <vector>

namespace edgewise::house {

struct FunctionSpan {
    std::size_t first = 0, last = 0;  ///< lines, from 1: of the name, and of the closing brace
};

[[nodiscard]] std::vector<FunctionSpan> function_spans(const std::vector<std::string>& lines);

/// The text with comments, literals and preprocessor lines blanked out; line breaks stay.
[[nodiscard]] std::string bare_code(const std::vector<std::string>& lines);

}  // namespace edgewise::house
