// SPDX-License-Identifier: MIT
//
// The report's prose, chart specifications and claims, which are files next to the code that uses them and
// become text in the program (cmake/report_texts.cmake).
#pragma once

#include <fmt/core.h>

#include <span>
#include <string>
#include <string_view>

namespace edgewise::reports {

/// Returns the file of this name, in whichever folder below reports/ it is: "stability.md", "bytes.vl.json".
/// The program names only files that are there; the unit tests read them all.
[[nodiscard]] std::string_view report_text(std::string_view name);

struct EmbeddedText {
    std::string_view name, text;
};
/// Returns all texts; generated.
[[nodiscard]] std::span<const EmbeddedText> embedded_texts();

/// A Markdown file as one paragraph: line ends become spaces.
[[nodiscard]] std::string prose(std::string_view name);

/// Returns the paragraph with its {placeholders} filled, by fmt::arg.
template <class... Arguments>
[[nodiscard]] std::string prose(std::string_view name, const Arguments&... arguments) {
    return fmt::format(fmt::runtime(prose(name)), arguments...);
}

}  // namespace edgewise::reports
