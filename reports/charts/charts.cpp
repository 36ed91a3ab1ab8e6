// SPDX-License-Identifier: MIT
//
// What the charts share; see charts.hpp.
#include "edgewise/reports/charts/charts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/tables/cache_tables.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/tables/text.hpp"

namespace edgewise::reports {

namespace {

/// Ten plain colours and ten dark ones, all readable on white; beyond twenty layouts they repeat.
const char* const palette[] = {"#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17becf", "#8c564b",
                               "#e377c2", "#7f7f7f", "#a3a500", "#0b3c5d", "#8b1a1a", "#145a14", "#4b2e83",
                               "#a65200", "#0b6e78", "#4a2c24", "#9b2f72", "#3f3f3f", "#6f7010"};

/// The distinct values of a member, those in `first` before the rest, the rest in order of name.
std::vector<std::string> ordered_names(const ReportData& data, std::string ReportCell::*member,
                                       const std::vector<std::string>& first) {
    std::set<std::string> present;
    for (const auto* rows : {&data.cells, &data.stability, &data.from_files, &data.paging})
        for (const ReportCell& row : *rows) present.insert(row.*member);
    std::vector<std::string> names;
    for (const std::string& name : first)
        if (present.erase(name)) names.push_back(name);
    names.insert(names.end(), present.begin(), present.end());
    return names;
}

}  // namespace

std::vector<Chart> all_charts(const ReportData& data) {
    std::vector<Chart> charts = {bytes_chart(data), time_chart(data), speed_error_chart(data),
                                 ratio_chart(data)};
    if (!modelled_cells(data).empty()) charts.push_back(misses_chart(data));
    if (!data.stability.empty()) charts.insert(charts.end(), {tolerance_chart(data), gap_chart(data)});
    for (Chart& chart : chapter_charts(data)) charts.push_back(std::move(chart));
    return charts;
}

ChartJson cell_json(const ReportCell& cell) {
    return {{"scene", cell.scene_label},   {"shape", cell.shape},   {"vertices", cell.vertices},
            {"algorithm", cell.algorithm}, {"layout", cell.layout}, {"precision", cell.precision},
            {"table", cell.table}};
}

ChartJson chart_config() {
    return {
        {"font", "system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif"},
        {"background", "white"},
        {"view", {{"stroke", "#d0d0d0"}}},
        {"axis",
         {{"labelFontSize", 11},
          {"titleFontSize", 12},
          {"titleFontWeight", "normal"},
          {"gridColor", "#ececec"},
          {"domainColor", "#888"},
          {"tickColor", "#888"},
          {"labelLimit", 240}}},
        {"legend",
         {{"labelFontSize", 11}, {"titleFontSize", 12}, {"symbolStrokeWidth", 2}, {"labelLimit", 240}}},
        {"header",
         {{"labelFontSize", 12}, {"labelFontWeight", "bold"}, {"titleFontSize", 12}, {"labelLimit", 600}}}};
}

ChartJson layout_colour(const ReportData& data) {
    const auto names = ordered_names(data, &ReportCell::layout, {"aos", "soa"});
    ChartJson colours = ChartJson::array();
    for (std::size_t i = 0; i < names.size(); ++i) colours.push_back(palette[i % std::size(palette)]);
    return {{"field", "layout"},
            {"type", "nominal"},
            {"scale", {{"domain", names}, {"range", colours}}},
            {"legend", {{"symbolLimit", 60}, {"symbolType", "circle"}, {"symbolOpacity", 1}}}};
}

std::vector<std::string> algorithm_names(const ReportData& data) {
    return ordered_names(data, &ReportCell::algorithm, {"vclip", "gjk"});
}

ChartJson equal_filter(const std::string& field, const std::string& value) {
    return {{"filter", {{"field", field}, {"equal", value}}}};
}

ChartJson log_scale() { return {{"type", "log"}, {"nice", false}, {"padding", 12}}; }

ChartJson scene_rows(const ReportData& data) {
    return {{"field", "scene"},
            {"type", "nominal"},
            {"title", nullptr},
            {"sort", scene_labels(data)},
            // The parameters on a line of their own: together they are longer than a panel is high.
            {"header",
             {{"labelExpr", "split(replace(datum.label, ')', ''), ' (')"},
              {"labelFontSize", 10},
              {"labelLimit", 420}}}};
}

ChartJson algorithm_shape(const ReportData& data) {
    const auto names = algorithm_names(data);
    const char* const shapes[] = {"circle", "triangle-up", "square", "diamond", "cross", "triangle-down"};
    ChartJson range = ChartJson::array();
    for (std::size_t i = 0; i < names.size(); ++i) range.push_back(shapes[i % std::size(shapes)]);
    return {{"field", "algorithm"},
            {"type", "nominal"},
            {"scale", {{"domain", names}, {"range", range}}},
            {"legend", {{"symbolOpacity", 1}}}};
}

ChartJson precision_dash(const ReportData& data) {
    const auto names = ordered_names(data, &ReportCell::precision, {"f64", "f32", "mixed"});
    const ChartJson dashes[] = {{1, 0}, {6, 3}, {2, 2}, {8, 3, 2, 3}};
    ChartJson range = ChartJson::array();
    for (std::size_t i = 0; i < names.size(); ++i) range.push_back(dashes[i % std::size(dashes)]);
    return {{"field", "precision"},
            {"type", "nominal"},
            {"scale", {{"domain", names}, {"range", range}}},
            {"legend", {{"symbolType", "stroke"}, {"symbolSize", 400}, {"symbolOpacity", 1}}}};
}

ChartJson legend_pick(const std::string& field) {
    return {{"name", field + "_pick"},
            {"select", {{"type", "point"}, {"fields", ChartJson::array({field})}}},
            {"bind", "legend"}};
}

ChartJson picked_opacity(const std::vector<std::string>& fields) {
    ChartJson all = ChartJson::array();
    for (const std::string& field : fields) all.push_back({{"param", field + "_pick"}});
    return {{"condition", {{"test", {{"and", all}}}, {"value", 0.9}}}, {"value", 0.06}};
}

void thin(ChartJson& values, std::size_t rows, std::vector<std::string>& notes) {
    if (values.size() <= rows || rows == 0) return;
    const std::size_t step = (values.size() + rows - 1) / rows;
    ChartJson kept = ChartJson::array();
    for (std::size_t i = 0; i < values.size(); i += step) kept.push_back(values[i]);
    notes.push_back(fmt::format("{} of {} rows are drawn, every {}th; results.csv has them all.", kept.size(),
                                values.size(), step));
    values = std::move(kept);
}

void Omissions::add(const std::string& reason) {
    for (auto& [known, count] : counts_)
        if (known == reason) {
            ++count;
            return;
        }
    counts_.emplace_back(reason, 1);
}

void Omissions::write(const std::string& noun, std::vector<std::string>& notes) const {
    for (const auto& [reason, count] : counts_)
        notes.push_back(fmt::format("Not measured, so not drawn: {} ({}).", plural(count, noun), reason));
}

TextGrid data_grid(const ChartJson& values, const std::vector<std::string>& fields) {
    constexpr std::size_t rows = 30;
    TextGrid grid;
    for (const std::string& field : fields)
        grid.columns.push_back({field, !values.empty() && values[0].value(field, ChartJson()).is_number()});
    for (std::size_t i = 0; i < std::min(rows, values.size()); ++i) {
        std::vector<GridCell> row;
        for (const std::string& field : fields) {
            const ChartJson value = values[i].value(field, ChartJson());
            if (value.is_number())
                row.push_back({number_text(value.get<double>())});
            else
                row.push_back({value.is_string() ? value.get<std::string>() : "–"});
        }
        grid.rows.push_back(std::move(row));
    }
    if (values.size() > rows)
        grid.caption = fmt::format("The first {} of {} rows; results.csv has them all.", rows, values.size());
    return grid;
}

std::vector<StabilityFigure> stability_figures(const ReportData& data, const store::FigureName& family) {
    std::vector<StabilityFigure> result;
    for (const ReportCell& row : data.stability) {
        for (const store::FigureRow& figure : row.figures) {
            const auto at = family.value_in(figure.probe, figure.name);
            if (at && figure.value) result.push_back({&row, *at, *figure.value});
        }
    }
    return result;
}

ChartJson table_json(const ReportData& data, const std::string& algorithm, const std::string& table) {
    ChartJson result{{"algorithm", algorithm}, {"table", table}};
    for (const ReportCell& row : data.stability) {
        if (row.table != table) continue;
        result["layout"] = row.layout;
        result["precision"] = row.precision;
        break;
    }
    return result;
}

ChartJson table_lines(const ReportData& data, const ChartJson& values, const ChartJson& x,
                      const ChartJson& y) {
    return {{"config", chart_config()},
            {"data", {{"values", values}}},
            {"width", 640},
            {"height", 300},
            {"params", ChartJson::array({legend_pick("layout"), legend_pick("precision")})},
            {"mark", {{"type", "line"}, {"point", true}, {"strokeWidth", 1.4}}},
            {"encoding",
             {{"x", x},
              {"y", y},
              {"color", layout_colour(data)},
              {"strokeDash", precision_dash(data)},
              {"shape", algorithm_shape(data)},
              {"detail", {{"field", "algorithm"}, {"type", "nominal"}}},
              {"opacity", picked_opacity({"layout", "precision"})}}}};
}

}  // namespace edgewise::reports
