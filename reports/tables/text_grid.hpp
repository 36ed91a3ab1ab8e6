// SPDX-License-Identifier: MIT
//
// A table as text, before it is HTML or Markdown: both pages show the same grids, so they cannot disagree.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

struct GridCell {
    std::string text;
    std::string why = {};  ///< not empty: there is no value, and this is the reason; text is "not measured"
};

struct GridColumn {
    std::string title;
    bool number = false;  ///< set flush right
};

struct TextGrid {
    std::string caption;
    std::vector<GridColumn> columns;
    std::vector<std::vector<GridCell>> rows;
};

/// The figure's number, or "not measured" with its reason and remedy.
[[nodiscard]] GridCell figure_cell(const measure::Figure& figure);
[[nodiscard]] GridCell missing_cell(const std::string& why);

[[nodiscard]] std::string grid_html(const TextGrid& grid);
[[nodiscard]] std::string grid_markdown(const TextGrid& grid);

}  // namespace edgewise::reports
