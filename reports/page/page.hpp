// SPDX-License-Identifier: MIT
//
// The report as one self-contained HTML file, complete in its statements without scripts, interactive with
// them, no network either way; and as Markdown of a length that a person pastes somewhere. What the scripts
// work on is JSON, column by column, which packs well: every cell and row of the store with every figure, the
// rows of long tables, and the specifications of the charts. A number is written with seven significant
// digits; a number that was not measured is the place of its reason, as text.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/page/pictures.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

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
/// every_cell; with "at" the places of the rows that have the figure, the others have none. A value is a
/// number, or the place of its reason and remedy as text, or null where the cell has no such figure.
[[nodiscard]] std::string cells_data(const ReportData& data);

/// [{"caption", "columns": [[title, is a number]], "cells": [[...] for each column]}]; a cell is its text, or
/// [text, reason].
[[nodiscard]] std::string grids_data(const std::vector<TextGrid>& grids);

/// {name: specification}; rows of its data as {"columns": {field: [...]}, "rows": n}.
[[nodiscard]] std::string charts_data(const std::vector<Chart>& charts);

}  // namespace edgewise::reports
