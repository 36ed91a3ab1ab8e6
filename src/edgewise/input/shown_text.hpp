// SPDX-License-Identifier: MIT
//
// Texts of files and stores before they are shown. A name may hold the codes by which a terminal moves its
// cursor, marks that turn the direction of writing, or bytes that are no UTF-8: each is shown as its number,
// so that the reader sees all of the text and nothing acts on it.
#pragma once

#include <string>
#include <string_view>

namespace edgewise::input {

/// The text with "\x1B" for a control character, "\u202E" for a mark of direction and "\xFF" for a byte that
/// is no UTF-8. Line ends and tabs stay.
[[nodiscard]] std::string shown_text(std::string_view text);

/// The same as one line: line ends and tabs are control characters too.
[[nodiscard]] std::string shown_line(std::string_view text);

/// Only bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string valid_utf8(std::string_view text);

/// Control characters and marks of direction within the strings of valid JSON, as JSON escapes them.
[[nodiscard]] std::string json_escaped(std::string_view json);

}  // namespace edgewise::input
