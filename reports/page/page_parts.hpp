// SPDX-License-Identifier: MIT
//
// Pieces of the page that more than one chapter is made of.
#pragma once

#include <string>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/page/pictures.hpp"

namespace edgewise::reports {

/// One paragraph; `style` is a class of the style sheet, or empty.
[[nodiscard]] std::string html_paragraph(const std::string& text, const std::string& style = {});
/// A chapter's heading, with the name that links use.
[[nodiscard]] std::string html_heading(const std::string& id, const std::string& text);
/// What a reader opens with a click.
[[nodiscard]] std::string html_folded(const std::string& summary, const std::string& inside);
/// Title, words, picture or fallback, notes; `alive`: with its specification for the scripts; `level`: of its
/// heading, such as "h3".
[[nodiscard]] std::string html_chart(const Chart& chart, const StaticPictures& pictures, bool alive,
                                     const std::string& level);
/// Likewise as Markdown; the picture is linked, where there is one. `level`: of its heading, such as "###".
[[nodiscard]] std::string markdown_chart(const Chart& chart, const StaticPictures& pictures,
                                         const std::string& level);

}  // namespace edgewise::reports
