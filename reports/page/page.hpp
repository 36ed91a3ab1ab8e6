// SPDX-License-Identifier: MIT
//
// The report as one self-contained HTML file, complete in its statements without scripts, interactive with
// them, no network either way; and as Markdown of a length that a person pastes somewhere. What the scripts
// work on is JSON, column by column, which packs well: every cell and row of the store with every figure, the
// rows of long tables, and the specifications of the charts. A number is written with seven significant
// digits; a number that was not measured is the place of its reason, as text.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

// Static pictures of the charts: each specification becomes figures/NAME.svg by node, with the same bundles
// that the page uses. Optional: without node or bundles the page shows small tables instead, and says so. And
// the files for citing a figure: its picture as PDF next to the SVG, its points as CSV, and a text with the
// commands that made it.

struct StaticPictures {
    std::map<std::string, std::string> svg;    ///< by chart name
    std::map<std::string, std::string> still;  ///< likewise, small enough for the page (most_still_bytes)
    std::string note;                          ///< why some or all are missing; empty when none is
};

inline constexpr std::size_t most_still_bytes = 20000;

/// Writes figures/NAME.vl.json for every chart and, where node can, figures/NAME.svg; old pictures are
/// removed. `tables`: the few table types that a still picture shows where all would be too many.
[[nodiscard]] StaticPictures write_pictures(const std::vector<Chart>& charts,
                                            const std::set<std::string>& tables,
                                            const std::filesystem::path& out,
                                            const std::filesystem::path& bundles);

/// Writes figures/NAME.csv, NAME.txt and, where there is an SVG and rsvg-convert can, NAME.pdf below `out`;
/// old ones are removed. The same store gives the same bytes. Returns why a PDF is missing, in one line;
/// empty where none is.
std::string write_cited_figures(const ReportData& data, const std::vector<Chart>& charts,
                                const StaticPictures& pictures, const std::filesystem::path& out);

/// Returns the points of a chart as CSV: a row each, and a column for every member that a point has.
[[nodiscard]] std::string points_csv(const ChartJson& points);

// The page and the Markdown.

/// `bundles`: what bundle_elements gives, or empty when they were not available.
[[nodiscard]] std::string page_html(const ReportData& data, const Answer& answer,
                                    const std::vector<Chapter>& chapters, const std::vector<Chart>& charts,
                                    const StaticPictures& pictures, const std::string& bundles);

/// `changes`: what chapter_markdown makes of its chapter, or empty where nothing is compared.
[[nodiscard]] std::string report_markdown(const ReportData& data, const Answer& answer,
                                          const StaticPictures& pictures, const std::string& changes = {});
/// Returns a chapter with the first rows of its tables.
[[nodiscard]] std::string chapter_markdown(const Chapter& chapter);

/// {"cells": {column: [...]}, "figures": [{"name", "unit", "values": [...]}], "reasons": [...]}: rows as in
/// rows_and_peers; with "at" the places of the rows that have the figure, the others have none. A value is a
/// number, or the place of its reason and remedy as text, or null where the cell has no such figure.
[[nodiscard]] std::string cells_data(const ReportData& data);

/// [{"caption", "columns": [[title, is a number]], "cells": [[...] for each column]}]; a cell is its text, or
/// [text, reason].
[[nodiscard]] std::string grids_data(const std::vector<TextGrid>& grids);

/// {name: specification}; rows of its data as {"columns": {field: [...]}, "rows": n}.
[[nodiscard]] std::string charts_data(const std::vector<Chart>& charts);

// What the page opens with: the question, the decision table, folded all contenders with a strip for each
// scene and time against bytes, and what failed or is missing. No script is needed for it.

/// The most scenes in full view; the page's list of cells has them all.
inline constexpr std::size_t most_answer_rows = 12;

/// Returns the answer's table as a grid without strips.
[[nodiscard]] TextGrid answer_grid(const Answer& answer);

/// Returns title, question bar, decision table, counts and provenance.
[[nodiscard]] std::string first_screen_html(const Answer& answer, const ReportData& data);

/// The answers to the questions that the bar offers, as JSON: {"lines": [...], "answers": {"SHAPE LIMIT
/// TABLES BODIES": {"title", "command", "html"}}}. SHAPE is empty for all bodies, TABLES is both, own or
/// shared, BODIES is empty for any number, and 0 for a number that was not measured; "html" has places in
/// "lines", because most lines are in several answers.
[[nodiscard]] std::string answers_data(const ReportData& data);

}  // namespace edgewise::reports
