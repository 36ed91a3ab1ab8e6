// SPDX-License-Identifier: MIT
//
// Texts of files and stores before they are shown. A name may hold the codes by which a terminal moves its
// cursor, marks that turn the direction of writing, or bytes that are not UTF-8: each is shown as its number,
// so that the reader sees all of the text and the terminal does not act on it.
#pragma once

#include <string>
#include <string_view>

namespace edgewise::input {

/// The text with "\x1B" for a control character, "\u202E" for a mark of direction and "\xFF" for a byte that
/// is no UTF-8. Line ends and tabs stay.
[[nodiscard]] std::string shown_text(std::string_view text);

/// The text as one line: as shown_text, with numbers for line ends and tabs too.
[[nodiscard]] std::string shown_line(std::string_view text);

/// The text with numbers for bytes that are not UTF-8, and nothing else replaced.
[[nodiscard]] std::string valid_utf8(std::string_view text);

/// Valid JSON with control characters and marks of direction in its strings escaped.
[[nodiscard]] std::string json_escaped(std::string_view json);

}  // namespace edgewise::input
