// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/chapters/chapters.hpp"

#include <fmt/format.h>

#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

using measure::Outcome;

std::string shown_value(const measure::RecordRow& row) {
    return row.has_interval ? fmt::format("{:.3f} [{:.3f}, {:.3f}]", row.value, row.low, row.high)
                            : fmt::format("{:.6g}", row.value);
}

std::string change_text(const measure::ComparedRow& row) {
    if (row.change() == 0) return "new";
    return row.is.has_interval
               ? fmt::format("{:.3f} [{:.3f}, {:.3f}]", row.change(), row.least_change(), row.most_change())
               : fmt::format("{:.3f}", row.change());
}

/// Rows of one outcome, in the comparison's order.
TextGrid rows_grid(const char* title, const measure::RecordComparison& found, Outcome outcome) {
    TextGrid grid{title, columns_of("figure|#before|#after|#after / before|made of|cell"), {}};
    for (const measure::ComparedRow& row : found.rows)
        if (row.outcome == outcome)
            grid.rows.push_back(grid_row(row.is.figure, shown_value(row.was), shown_value(row.is),
                                         change_text(row), row.note, row.is.cell));
    return grid;
}

TextGrid conditions_grid(const measure::RecordComparison& found) {
    TextGrid grid{"What else differs, and may be the cause", columns_of("what|before|after|as a cause"), {}};
    for (const measure::ComparedCondition& condition : found.conditions)
        grid.rows.push_back(grid_row(condition.what, condition.was, condition.is,
                                     condition.same() ? "excluded" : "possible"));
    grid.shown_rows = grid.rows.size();
    return grid;
}

}  // namespace

Chapter compare_chapter(const StoreComparison& comparison, double slack, const std::string& other) {
    const measure::RecordComparison& found = comparison.found;
    Chapter chapter{
        .id = "changes",
        .title = "What changed since " + other + "?",
        .paragraph =
            prose("comparison.md", fmt::arg("slack", 100 * slack),
                  fmt::arg("noise_low", comparison.noise_low), fmt::arg("noise_high", comparison.noise_high)),
        .link = "What changed",
        .sentence = fmt::format(
            "{} of {} figures in both stores became worse, {} better; {} cells or figures are missing, {} new.",
            found.count(Outcome::worse), found.compared(), found.count(Outcome::better),
            found.count(Outcome::missing), found.count(Outcome::added))};
    for (auto& [title, outcome] : {std::pair("Worse", Outcome::worse), std::pair("Better", Outcome::better)})
        if (TextGrid grid = rows_grid(title, found, outcome); !grid.rows.empty())
            chapter.blocks.push_back({.grids = {std::move(grid)}});
    chapter.blocks.push_back({.grids = {conditions_grid(found)}});
    return chapter;
}

}  // namespace edgewise::reports
