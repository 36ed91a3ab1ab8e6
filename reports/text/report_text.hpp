// SPDX-License-Identifier: MIT
//
// The report's prose, chart specifications and claims, which are files next to the code that uses them and
// become text in the program (cmake/report_texts.cmake).
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <span>
#include <string>
#include <string_view>

namespace edgewise::reports {

struct EmbeddedText {
    std::string_view name, text;
};
/// Returns all texts; generated.
[[nodiscard]] std::span<const EmbeddedText> embedded_texts();

/// Returns the file of this name, in whichever folder below reports/ it is: "stability.md", "bytes.vl.json".
/// The program names only files that are there; the unit tests read them all.
[[nodiscard]] inline std::string_view report_text(std::string_view name) {
    const auto found = std::ranges::find(embedded_texts(), name, &EmbeddedText::name);
    assert(found != embedded_texts().end());
    return found->text;
}

/// A Markdown file as one paragraph: line ends become spaces.
[[nodiscard]] inline std::string prose(std::string_view name) {
    std::string paragraph(report_text(name));
    while (!paragraph.empty() && paragraph.back() == '\n') paragraph.pop_back();
    std::ranges::replace(paragraph, '\n', ' ');
    return paragraph;
}

/// Returns the paragraph with its {placeholders} filled, by fmt::arg.
template <class... Arguments>
[[nodiscard]] std::string prose(std::string_view name, const Arguments&... arguments) {
    return fmt::format(fmt::runtime(prose(name)), arguments...);
}

}  // namespace edgewise::reports
