// SPDX-License-Identifier: MIT
//
// A table as text, before it is HTML or Markdown: both pages show the same grids, so they cannot disagree.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
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
    std::size_t shown_rows = 8;  ///< in full view on the page, where a longer grid has all on demand
};

/// Takes out columns of numbers that are 0 in every row; a sentence after the caption names them.
void drop_zero_columns(TextGrid& grid);

/// The figure's number divided by `unit`, with as many digits as it has meaning where `digits` names none; a
/// star where its unit says that it is unverified. Or "not measured" with its reason and remedy.
[[nodiscard]] GridCell figure_cell(const measure::Figure& figure, double unit = 1, int digits = -1);
/// One figure over another, or which of the two is not there.
[[nodiscard]] GridCell ratio_cell(const measure::Figure& above, const measure::Figure& below);
[[nodiscard]] GridCell missing_cell(const std::string& why);

/// From titles with bars between them, "scene|#tables|#ns": '#' stands before those that are set flush right.
[[nodiscard]] std::vector<GridColumn> columns_of(std::string_view titles);

[[nodiscard]] inline GridCell grid_cell(const GridCell& cell) { return cell; }
[[nodiscard]] inline GridCell grid_cell(const measure::Figure& figure) { return figure_cell(figure); }
[[nodiscard]] inline GridCell grid_cell(const std::string& text) { return {text}; }
[[nodiscard]] inline GridCell grid_cell(const char* text) { return {text}; }
[[nodiscard]] inline GridCell grid_cell(std::string_view text) { return {std::string(text)}; }
template <std::integral Number>
[[nodiscard]] GridCell grid_cell(Number number) {
    return {std::to_string(number)};
}
/// A cell of each: text, a whole number, a figure, or a cell as it is.
template <class... Cells>
[[nodiscard]] std::vector<GridCell> grid_row(const Cells&... cells) {
    return {grid_cell(cells)...};
}

/// A column that shows one figure of each row's cell, as figure_cell does.
struct FigureColumn {
    std::string title;
    store::FigureName figure;
    double unit = 1;
    int digits = -1;
};
/// A grid without rows: columns that name what a row is of, as in columns_of, then one for each figure.
template <class FigureColumns>
[[nodiscard]] TextGrid figure_grid(std::string caption, std::string_view names,
                                   const FigureColumns& columns) {
    TextGrid grid{std::move(caption), columns_of(names), {}};
    for (const FigureColumn& column : columns) grid.columns.push_back({column.title, true});
    return grid;
}
template <class FigureColumns>
void add_row(TextGrid& grid, std::vector<GridCell> names, const ReportCell& cell,
             const FigureColumns& columns) {
    for (const FigureColumn& column : columns)
        names.push_back(figure_cell(cell.figure(column.figure), column.unit, column.digits));
    grid.rows.push_back(std::move(names));
}

/// `most`: rows of it.
[[nodiscard]] std::string grid_html(const TextGrid& grid, std::size_t most = static_cast<std::size_t>(-1));
[[nodiscard]] std::string grid_markdown(const TextGrid& grid);

}  // namespace edgewise::reports
