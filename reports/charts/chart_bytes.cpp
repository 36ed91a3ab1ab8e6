// SPDX-License-Identifier: MIT
//
// Bytes per edge by component: one bar a table type, one panel an algorithm, one shape at a time.
#include <algorithm>
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

const char* const component_colours[] = {"#1f4e79", "#4a90c2", "#a8d0e6", "#e0a458", "#8d6a9f",
                                         "#c9c9c9", "#7fb069", "#d1495b", "#66a182", "#2e4057"};

std::string in_words(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/// One row a component, once for each algorithm, table type and shape.
ChartJson component_rows(const ReportData& data, const std::vector<std::string>& components,
                         Omissions& omitted) {
    ChartJson values = ChartJson::array();
    std::set<std::string> seen;
    for (const ReportCell& cell : data.cells) {
        if (!cell.verified()) continue;
        if (!seen.insert(cell.algorithm + '\n' + cell.table + '\n' + cell.shape).second) continue;
        for (std::size_t i = 0; i < components.size(); ++i) {
            const measure::Figure figure = cell.figure("bytes", components[i]);
            if (!figure.value) {
                omitted.add(in_words(components[i]) + ": " + figure.reason);
                continue;
            }
            ChartJson row = cell_json(cell);
            row["component"] = in_words(components[i]);
            row["order"] = i;
            row["bytes"] = *figure.value;
            values.push_back(std::move(row));
        }
    }
    return values;
}

ChartJson component_colour(const std::vector<std::string>& components) {
    ChartJson names = ChartJson::array(), colours = ChartJson::array();
    for (std::size_t i = 0; i < components.size(); ++i) {
        names.push_back(in_words(components[i]));
        colours.push_back(component_colours[i % std::size(component_colours)]);
    }
    return {{"field", "component"},
            {"type", "nominal"},
            {"scale", {{"domain", names}, {"range", colours}}},
            {"legend", {{"orient", "top"}, {"title", nullptr}, {"columns", 6}}}};
}

ChartJson bar_layer(const std::vector<std::string>& components, bool holds_pick) {
    // A parameter lives in one panel; the others refer to it by name.
    const ChartJson params = holds_pick ? ChartJson::array({legend_pick("component")}) : ChartJson::array();
    return {
        {"params", params},
        {"mark", {{"type", "bar"}}},
        {"encoding",
         {{"y", {{"field", "table"}, {"type", "nominal"}, {"title", nullptr}}},
          {"x",
           {{"field", "bytes"},
            {"type", "quantitative"},
            {"title", "bytes per edge"},
            {"stack", "zero"},
            {"axis", {{"tickCount", 10}}}}},
          {"color", component_colour(components)},
          {"order", {{"field", "order"}, {"type", "quantitative"}}},
          {"opacity", {{"condition", {{"param", "component_pick"}, {"value", 1}}}, {"value", 0.15}}},
          {"tooltip", ChartJson::array({{{"field", "table"}, {"type", "nominal"}, {"title", "table type"}},
                                        {{"field", "algorithm"}, {"type", "nominal"}},
                                        {{"field", "shape"}, {"type", "nominal"}},
                                        {{"field", "component"}, {"type", "nominal"}},
                                        {{"field", "bytes"},
                                         {"type", "quantitative"},
                                         {"format", ".2f"},
                                         {"title", "bytes per edge"}}})}}}};
}

/// The paper's two figures as dashed lines with their names above.
ChartJson paper_layers() {
    const ChartJson data{{"values", ChartJson::array({{{"paper", 168}, {"name", "paper, double: 168"}},
                                                      {{"paper", 84}, {"name", "paper, single: 84"}}})}};
    const ChartJson x{{"field", "paper"}, {"type", "quantitative"}};
    const ChartJson rule{{"type", "rule"}, {"strokeDash", {4, 3}}, {"color", "#111"}};
    const ChartJson text{{"type", "text"}, {"fontSize", 10}, {"dy", -6}, {"color", "#333"}};
    const ChartJson name{{"field", "name"}, {"type", "nominal"}};
    return {
        {{"data", data}, {"mark", rule}, {"encoding", {{"x", x}}}},
        {{"data", data}, {"mark", text}, {"encoding", {{"x", x}, {"y", {{"value", 0}}}, {"text", name}}}}};
}

/// A panel an algorithm, with its own table types.
ChartJson panels(const ReportData& data, const std::vector<std::string>& components) {
    ChartJson list = ChartJson::array();
    for (const std::string& algorithm : algorithm_names(data)) {
        ChartJson layers = ChartJson::array({bar_layer(components, list.empty())});
        for (const ChartJson& layer : paper_layers()) layers.push_back(layer);
        list.push_back(
            {{"title", {{"text", algorithm}, {"anchor", "start"}, {"fontSize", 12}, {"offset", 14}}},
             {"transform", ChartJson::array({equal_filter("algorithm", algorithm)})},
             {"width", 780},
             {"height", {{"step", 19}}},
             {"layer", layers}});
    }
    return list;
}

ChartJson shape_choice(const ReportData& data) {
    std::vector<std::pair<std::int64_t, std::string>> shapes;
    for (const ReportCell& cell : data.cells) shapes.emplace_back(cell.vertices, cell.shape);
    std::sort(shapes.begin(), shapes.end());
    ChartJson names = ChartJson::array();
    for (const auto& [vertices, name] : shapes)
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    return {{"name", "shown_shape"},
            {"value", reference_shape(data)},
            {"bind", {{"input", "select"}, {"options", names}, {"name", "Shape: "}}}};
}

}  // namespace

Chart bytes_chart(const ReportData& data) {
    const auto components = byte_components(data);
    Chart chart{
        "bytes",
        "Bytes per edge by component",
        "Each bar is a table type's memory over its edges, split into what the bytes hold; the first three "
        "parts are what the paper counts. The dashed lines are the paper's 168 bytes per edge in double and "
        "84 in single precision. A table holds only the parts that its algorithm asks for; choose the shape "
        "below the chart.",
        nullptr,
        {},
        {}};
    Omissions omitted;
    ChartJson values = component_rows(data, components, omitted);
    omitted.write("component bar", chart.notes);
    thin(values, mark_limit, chart.notes);
    if (values.empty()) return chart;
    chart.spec = {{"config", chart_config()},
                  {"params", ChartJson::array({shape_choice(data)})},
                  {"data", {{"values", values}}},
                  {"transform", ChartJson::array({{{"filter", "datum.shape === shown_shape"}}})},
                  {"vconcat", panels(data, components)},
                  // One scale for all: the panels are there to be compared.
                  {"resolve", {{"scale", {{"x", "shared"}}}}}};
    ChartJson shown = ChartJson::array();
    for (const ChartJson& row : values)
        if (row["shape"] == reference_shape(data)) shown.push_back(row);
    chart.fallback = data_grid(shown, {"algorithm", "table", "shape", "component", "bytes"});
    return chart;
}

}  // namespace edgewise::reports
