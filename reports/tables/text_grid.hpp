// SPDX-License-Identifier: MIT
//
// A table before it is HTML, Markdown or lines of a terminal: pages and commands show the same grids, so they
// cannot disagree. Rows are cells of a store, or objects of the JSON that a command prints.
#pragma once

#include <concepts>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

struct GridCell {
    std::string text;
    std::string why = {};  ///< not empty: there is no value, and this is the reason; text is "not measured"

    auto operator<=>(const GridCell&) const = default;
};

struct GridColumn {
    std::string title;
    bool number = false;  ///< set flush right
};

/// Returns the figure's number divided by `unit`, with `digits` decimals or, if negative, as number_text; a
/// star follows if its unit says that it is unverified. Without a value: "not measured" with reason and
/// remedy.
[[nodiscard]] GridCell figure_cell(const measure::Figure& figure, double unit = 1, int digits = -1);
/// Returns one figure over another, or the reason for the one that is missing.
[[nodiscard]] GridCell ratio_cell(const measure::Figure& above, const measure::Figure& below);
[[nodiscard]] GridCell missing_cell(const std::string& why);
/// A figure of a cell, and one of a cell over one of another; a dash where the store has no such cell.
[[nodiscard]] GridCell figure_cell(const ReportCell* cell, const store::FigureName& name);
[[nodiscard]] GridCell ratio_cell(const ReportCell* above, const store::FigureName& name,
                                  const ReportCell* below, const store::FigureName& name_below);
/// "0.98 [0.95, 1.01]"
[[nodiscard]] GridCell interval_cell(const measure::Figure& middle, const measure::Figure& low,
                                     const measure::Figure& high, int digits);

/// Returns columns from titles with bars between them, "scene|#tables|#ns"; '#' marks columns that are set
/// flush right.
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

struct TextGrid {
    std::string caption;
    std::vector<GridColumn> columns;
    std::vector<std::vector<GridCell>> rows = {};
    std::size_t shown_rows = 8;  ///< in full view on the page, where a longer grid has all on demand

    /// A row of cells, each as grid_cell takes it.
    template <class... Cells>
    void add(const Cells&... cells) {
        rows.push_back(grid_row(cells...));
    }
};

/// Takes out columns of numbers that are 0 in every row; a sentence after the caption names them.
void drop_zero_columns(TextGrid& grid);

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
    TextGrid grid{std::move(caption), columns_of(names)};
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

/// Returns a cell's value for a name with which rows begin: "scene", "shape", "table type", ...
[[nodiscard]] GridCell name_cell(const ReportCell& cell, std::string_view name);
inline constexpr std::string_view cell_names = "scene|shape|algorithm|table type";
/// A row for each cell: its names, each by its column's title, then its figures.
template <class FigureColumns>
[[nodiscard]] TextGrid cell_grid(std::string caption, std::string_view names, const FigureColumns& columns,
                                 const std::vector<const ReportCell*>& cells) {
    TextGrid grid = figure_grid(std::move(caption), names, columns);
    const std::vector<GridColumn> named = columns_of(names);
    for (const ReportCell* cell : cells) {
        std::vector<GridCell> row;
        for (const GridColumn& name : named) row.push_back(name_cell(*cell, name.title));
        add_row(grid, std::move(row), *cell, columns);
    }
    return grid;
}

/// A grid over rows of JSON. `columns`: titles as in columns_of, each with the member that it shows unless
/// that is the title itself, by what it is divided, and the digits behind the point: "#KiB = bytes 1024
/// 0|level". Slashes separate the names of nested members. A null or absent member is missing for the
/// "reason" and "remedy" next to it, or of its row.
[[nodiscard]] TextGrid member_grid(const nlohmann::json& rows, std::string_view columns);

/// Returns the first `most` rows as HTML.
[[nodiscard]] std::string grid_html(const TextGrid& grid, std::size_t most = static_cast<std::size_t>(-1));
[[nodiscard]] std::string grid_markdown(const TextGrid& grid);
/// Lines for a terminal, without the caption: columns as wide as their cells, numbers flush right,
/// and the last column folded at `width` characters as far as the others leave room for words. A dash where
/// there is no value; reasons are numbered below.
[[nodiscard]] std::string grid_text(const TextGrid& grid, std::size_t width = widest_line);
[[nodiscard]] inline std::string rows_text(const nlohmann::json& rows, std::string_view columns) {
    return grid_text(member_grid(rows, columns));
}

}  // namespace edgewise::reports
