// SPDX-License-Identifier: MIT
//
// What the page's scripts work on, as JSON, column by column, which packs well: every cell and row of the
// store with every figure, the rows of long tables, and the specifications of the charts. A number is written
// with seven significant digits; one that was not measured is the number of its reason, as text.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

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
