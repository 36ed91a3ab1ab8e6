// SPDX-License-Identifier: MIT
//
// What the page opens with: the question, the decision table, folded all contenders with a strip for each
// scene and time against bytes, and what failed or is missing. No script is needed for it.
#pragma once

#include <string>

#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// The most scenes in full view; the page's list of cells has them all.
inline constexpr std::size_t most_answer_rows = 12;

/// Returns the answer's table as a grid without strips.
[[nodiscard]] TextGrid answer_grid(const Answer& answer);

/// Returns title, question bar, decision table, counts and provenance.
[[nodiscard]] std::string first_screen_html(const Answer& answer, const ReportData& data);

/// The answers to the questions that the bar offers, as JSON: {"lines": [...], "answers": {"SHAPE LIMIT":
/// {"title", "command", "html"}}}. SHAPE is empty for all bodies; "html" has places in "lines", because most
/// lines are in several answers.
[[nodiscard]] std::string answers_data(const ReportData& data);

}  // namespace edgewise::reports
