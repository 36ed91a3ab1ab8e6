// SPDX-License-Identifier: MIT
//
// The few HTML elements that the page uses; all text is escaped here.
#pragma once

#include <string>
#include <vector>

namespace edgewise::reports {

/// Returns an element around `html`, which is HTML already. `style`: a class of the style sheet, or empty.
[[nodiscard]] std::string html_element(const std::string& name, const std::string& html,
                                       const std::string& style = {});
/// A paragraph of text.
[[nodiscard]] std::string html_paragraph(const std::string& text, const std::string& style = {});
/// A heading with the name that links use.
[[nodiscard]] std::string html_heading(const std::string& id, const std::string& text);
[[nodiscard]] std::string html_list(const std::vector<std::string>& items, const std::string& style);

/// A choice with a name; `options` is HTML, of html_option.
[[nodiscard]] std::string html_select(const std::string& id, const std::string& label,
                                      const std::string& options);
[[nodiscard]] std::string html_option(const std::string& value, const std::string& text, bool chosen = false);

}  // namespace edgewise::reports
