// SPDX-License-Identifier: MIT
//
// What the page opens with: the question, the answer in a paragraph and in a table with a strip in each row,
// time against bytes, and what failed or is missing. No script is needed for it.
#pragma once

#include <string>

#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// The most scenes in full view; the page's list of cells has them all.
inline constexpr std::size_t most_answer_rows = 12;

[[nodiscard]] std::string answer_rows_html(const Answer& answer);

/// Returns the answer's table as a grid without strips.
[[nodiscard]] TextGrid answer_grid(const Answer& answer);

/// Title, provenance, question bar, answer and counts.
[[nodiscard]] std::string first_screen_html(const Answer& answer, const ReportData& data);

/// The parts that follow the question: title, paragraph, table and pictures.
[[nodiscard]] std::string answer_html(const Answer& answer, const ReportData& data);

/// The answers to the questions that the bar offers, as JSON: {"SHAPE LIMIT": {"title", "command", "html"}}.
[[nodiscard]] std::string answers_data(const ReportData& data);

/// The limits that the bar offers.
inline constexpr double offered_limits[] = {1e-4, 1e-6, 1e-8, 1e-12};

}  // namespace edgewise::reports
