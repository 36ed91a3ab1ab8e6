// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/page.hpp"

#include <fmt/core.h>

#include <map>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/results/main_figures.hpp"

namespace edgewise::reports {

namespace {

std::string dumped(const ChartJson& json) { return input::json_text(json); }

/// Seven digits: what a count up to ten million has, and more than any time.
ChartJson rounded(double value) { return std::stod(fmt::format("{:.7g}", value)); }

/// Texts and their places, in order of appearance.
class Dictionary {
  public:
    std::size_t place(const std::string& text) {
        const auto [at, fresh] = places_.emplace(text, texts_.size());
        if (fresh) texts_.push_back(text);
        return at->second;
    }
    [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

  private:
    std::map<std::string, std::size_t> places_;
    std::vector<std::string> texts_;
};

ChartJson identity_columns(const std::vector<const ReportCell*>& cells) {
    ChartJson columns = ChartJson::object();
    const auto add = [&](const char* name, const auto& get) {
        ChartJson values = ChartJson::array();
        for (const ReportCell* cell : cells) values.push_back(get(*cell));
        columns[name] = std::move(values);
    };
    add("cell", [](const ReportCell& cell) { return cell.hash.substr(0, 12); });  // as in tables
    add("scene", [](const ReportCell& cell) { return cell.scene_label; });
    add("shape", [](const ReportCell& cell) { return cell.shape; });
    add("vertices", [](const ReportCell& cell) { return cell.vertices; });
    add("edges", [](const ReportCell& cell) { return cell.edges; });
    add("algorithm", [](const ReportCell& cell) { return cell.algorithm; });
    add("table", [](const ReportCell& cell) { return cell.table; });
    add("queries", [](const ReportCell& cell) { return cell.queries; });
    add("status", [](const ReportCell& cell) { return std::string(to_string(cell.status)); });
    add("reason", [](const ReportCell& cell) { return cell.reason; });
    return columns;
}

/// A figure's values over all cells.
struct FigureValues {
    std::string unit;
    std::vector<ChartJson> values;
};

ChartJson value_json(const store::FigureRow& figure, Dictionary& reasons) {
    if (figure.value) return rounded(*figure.value);
    const std::string why = figure.remedy.empty() ? figure.reason : figure.reason + " – " + figure.remedy;
    return std::to_string(reasons.place(why));
}

/// Returns the values of a figure; if less than half of the cells have it, only those, with places in "at".
ChartJson figure_json(const std::string& name, FigureValues& column, std::size_t cells) {
    ChartJson json = {{"name", name}, {"unit", column.unit}};
    ChartJson at = ChartJson::array(), values = ChartJson::array();
    for (std::size_t i = 0; i < column.values.size(); ++i) {
        if (column.values[i].is_null()) continue;
        at.push_back(i);
        values.push_back(column.values[i]);
    }
    if (2 * at.size() < cells) {
        json["at"] = std::move(at), json["values"] = std::move(values);
    } else {
        json["values"] = std::move(column.values);
    }
    return json;
}

ChartJson grid_json(const TextGrid& grid) {
    ChartJson columns = ChartJson::array(), cells = ChartJson::array();
    for (std::size_t i = 0; i < grid.columns.size(); ++i) {
        columns.push_back({grid.columns[i].title, grid.columns[i].number});
        ChartJson column = ChartJson::array();
        for (const auto& row : grid.rows)
            column.push_back(row[i].why.empty() ? ChartJson(row[i].text)
                                                : ChartJson::array({row[i].text, row[i].why}));
        cells.push_back(std::move(column));
    }
    return {{"caption", grid.caption}, {"columns", columns}, {"cells", cells}};
}

/// Rows as columns; a row without a field has null there.
ChartJson columns_json(const ChartJson& rows) {
    ChartJson columns = ChartJson::object();
    std::size_t place = 0;
    for (const ChartJson& row : rows) {
        for (const auto& [name, value] : row.items()) {
            ChartJson& column = columns[name];
            while (column.size() < place) column.push_back(nullptr);
            column.push_back(value.is_number_float() ? rounded(value.get<double>()) : value);
        }
        ++place;
    }
    for (ChartJson& column : columns)
        while (column.size() < place) column.push_back(nullptr);
    return {{"columns", columns}, {"rows", place}};
}

}  // namespace

std::string cells_data(const ReportData& data) {
    const std::vector<const ReportCell*> cells = every_cell(data);
    std::map<std::string, FigureValues> figures;
    Dictionary reasons;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (const store::FigureRow& figure : cells[i]->figures) {
            FigureValues& column = figures[figure_key(figure)];
            column.unit = figure.unit;
            column.values.resize(cells.size());
            column.values[i] = value_json(figure, reasons);
        }
    }
    ChartJson columns = ChartJson::array();
    for (auto& [name, column] : figures) columns.push_back(figure_json(name, column, cells.size()));
    return dumped(
        {{"cells", identity_columns(cells)}, {"figures", std::move(columns)}, {"reasons", reasons.texts()}});
}

std::string grids_data(const std::vector<TextGrid>& grids) {
    ChartJson all = ChartJson::array();
    for (const TextGrid& grid : grids) all.push_back(grid_json(grid));
    return dumped(all);
}

std::string charts_data(const std::vector<Chart>& charts) {
    ChartJson all = ChartJson::object();
    for (const Chart& chart : charts) {
        if (chart.spec.is_null()) continue;
        ChartJson spec = chart.spec;
        if (spec.contains("data") && spec["data"].contains("values"))
            spec["data"]["values"] = columns_json(spec["data"]["values"]);
        all[chart.name] = std::move(spec);
    }
    return dumped(all);
}

}  // namespace edgewise::reports
