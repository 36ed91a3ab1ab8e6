// SPDX-License-Identifier: MIT
//
// Made-up report data, by the names that the store uses.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// "time.all_ns" -> value.
using MadeUp = std::map<std::string, double>;

/// Rows of figures for pairs of "probe.name" and value.
template <class Values = MadeUp>
std::vector<store::FigureRow> figures_of(const Values& values) {
    std::vector<store::FigureRow> figures;
    for (const auto& [name, value] : values) {
        const std::size_t dot = name.find('.');
        figures.push_back({{name.substr(dot + 1), value, "1"}, name.substr(0, dot)});
    }
    return figures;
}

/// A cell of this layout in double precision, without figures; its vertices are the digits of the shape.
inline ReportCell base_cell(const std::string& scene, const std::string& shape, const std::string& algorithm,
                            const std::string& layout,
                            store::CellStatus status = store::CellStatus::verified) {
    ReportCell cell;
    cell.scene = cell.scene_label = scene;
    cell.shape = shape, cell.shape_source = "built-in";
    const auto digit = shape.find_first_of("0123456789");
    cell.vertices = digit == shape.npos ? 0 : std::stoi(shape.substr(digit));
    cell.algorithm = algorithm, cell.layout = layout, cell.precision = "f64", cell.table = layout + "_f64";
    cell.status = status;
    return cell;
}

inline ReportCell made_up_cell(const std::string& scene, const std::string& algorithm,
                               const std::string& parameters, const MadeUp& values) {
    ReportCell cell = base_cell(scene, "sphere", algorithm, "aos");
    cell.scene_parameters = parameters;
    cell.vertices = 8, cell.edges = 18;
    cell.figures = figures_of(values);
    return cell;
}

inline void add_scene(ReportData& data, const std::string& name, const std::string& varied) {
    const std::string vary = varied.empty() ? "" : R"(,"vary":{")" + varied + R"(":[1]})";
    data.scene_files.emplace_back(name, R"({"scene":"tumble")" + vary + "}");
}

/// Both algorithms at one point of a scene.
inline void add_both(ReportData& data, const std::string& scene, const std::string& parameters,
                     const MadeUp& values) {
    for (const char* algorithm : {"vclip", "gjk"})
        data.from_files.push_back(made_up_cell(scene, algorithm, parameters, values));
}

inline MadeUp times(double ns) {
    return {{"time.all_ns", ns},          {"time.all_ns_low", ns * .9}, {"time.all_ns_high", ns * 1.1},
            {"time.all_ratio", ns / 100}, {"time.separated_ns", ns},    {"time.overlapping_ns", ns / 2}};
}

/// Expects these texts in a row of a table, by column.
inline void expect_texts(const std::vector<GridCell>& row, const std::map<std::size_t, std::string>& wanted) {
    for (const auto& [column, text] : wanted) EXPECT_EQ(row.at(column).text, text) << "column " << column;
}

inline std::vector<std::string> texts_of(const std::vector<GridCell>& row) {
    std::vector<std::string> texts;
    for (const GridCell& cell : row) texts.push_back(cell.text);
    return texts;
}

/// Returns the cell of a row in the column of that title; `nth`: of several columns with one title.
inline const GridCell& cell_of(const TextGrid& grid, std::size_t row, const std::string& title,
                               std::size_t nth = 0) {
    for (std::size_t i = 0; i < grid.columns.size(); ++i)
        if (grid.columns[i].title == title && nth-- == 0) return grid.rows.at(row).at(i);
    throw std::invalid_argument("no column " + title);
}

/// Rows of a chart's data where `field` is `value`.
inline std::vector<ChartJson> rows_where(const ChartJson& values, const std::string& field,
                                         const ChartJson& value) {
    std::vector<ChartJson> rows;
    for (const ChartJson& row : values)
        if (row.contains(field) && row[field] == value) rows.push_back(row);
    return rows;
}

}  // namespace edgewise::reports
