// SPDX-License-Identifier: MIT
//
// See curves.hpp. The interval layer comes first and holds the layout's parameter: a composite error bar in
// its place would swallow legend clicks without a word.
#include "edgewise/reports/charts/curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace edgewise::reports {

namespace {

ChartJson variant_dash(const ChartJson& values) {
    const ChartJson dashes[] = {{1, 0}, {6, 3}, {2, 2}, {8, 3, 2, 3}, {1, 4}, {10, 2}, {4, 1, 1, 1, 1, 1}};
    std::set<std::string> names;
    for (const ChartJson& row : values)
        if (row.contains("variant")) names.insert(row["variant"].get<std::string>());
    std::vector<std::string> order;
    for (const char* first : {"f64", "f32", "mixed"})
        if (names.erase(first)) order.emplace_back(first);
    order.insert(order.end(), names.begin(), names.end());
    ChartJson range = ChartJson::array();
    for (std::size_t i = 0; i < order.size(); ++i) range.push_back(dashes[i % std::size(dashes)]);
    return {{"field", "variant"},
            {"type", "nominal"},
            {"title", "precision and axes"},
            {"scale", {{"domain", order}, {"range", range}}},
            {"legend", {{"symbolType", "stroke"}, {"symbolSize", 400}, {"symbolOpacity", 1}}}};
}

ChartJson point_shape(const ReportData& data, const ChartJson& values) {
    const char* const shapes[] = {"circle", "triangle-up", "square", "diamond", "cross", "triangle-down"};
    std::set<std::string> present;
    for (const ChartJson& row : values)
        if (row.contains("point")) present.insert(row["point"].get<std::string>());
    std::vector<std::string> order;
    for (const std::string& name : algorithm_names(data))
        if (present.erase(name)) order.push_back(name);
    order.insert(order.end(), present.begin(), present.end());
    ChartJson range = ChartJson::array();
    for (std::size_t i = 0; i < order.size(); ++i) range.push_back(shapes[i % std::size(shapes)]);
    return {{"field", "point"},
            {"type", "nominal"},
            {"title", "algorithm"},
            {"scale", {{"domain", order}, {"range", range}}},
            {"legend", {{"symbolOpacity", 1}}}};
}

ChartJson tooltip(const Curves& curves) {
    ChartJson fields = ChartJson::array();
    for (const char* name : {"table", "algorithm", "scene", "shape"})
        fields.push_back({{"field", name}, {"type", "nominal"}});
    std::vector<std::string> numbers{curves.x.field};
    numbers.insert(numbers.end(), curves.also.begin(), curves.also.end());
    numbers.push_back(curves.y.field);
    if (curves.has_interval) numbers.insert(numbers.end(), {"low", "high"});
    for (const std::string& name : numbers)
        fields.push_back({{"field", name}, {"type", "quantitative"}, {"format", ".4~g"}});
    return fields;
}

ChartJson interval_layer(const Curves& curves) {
    CurveAxis low = curves.y;
    low.field = "low";
    return {{"mark", {{"type", "rule"}, {"strokeWidth", 2}}},
            {"encoding", {{"y", curve_axis(low)}, {"y2", {{"field", "high"}}}}}};
}

}  // namespace

ChartJson curve_axis(const CurveAxis& axis) {
    ChartJson encoding{
        {"field", axis.field}, {"type", "quantitative"}, {"title", axis.title}, {"scale", axis.scale}};
    if (!axis.axis.is_null()) encoding["axis"] = axis.axis;
    return encoding;
}

ChartJson scale_with_zero(double constant) {
    return {{"type", "symlog"}, {"constant", constant}, {"nice", false}, {"padding", 12}};
}

ChartJson ticks_at(const std::vector<double>& places) {
    return {{"values", places}, {"format", "~g"}, {"labelOverlap", true}};
}

ChartJson scale_up_to(double most) { return {{"domain", {0, 1.15 * most}}, {"nice", true}}; }

ChartJson scale_from_zero() { return {{"zero", true}, {"nice", true}}; }

CurveAxis bytes_axis(const std::string& field, const std::string& title) {
    constexpr const char* label =
        "datum.value >= 1073741824 ? datum.value / 1073741824 + ' GiB' : datum.value >= 1048576 ? "
        "datum.value / 1048576 + ' MiB' : datum.value / 1024 + ' KiB'";
    return {field,
            title,
            {{"type", "log"}, {"base", 2}, {"nice", false}, {"padding", 8}},
            {{"labelExpr", label}, {"labelOverlap", true}, {"tickCount", 9}}};
}

ChartJson curve_json(const ReportCell& cell) {
    ChartJson row = cell_json(cell);
    row["scene"] = cell.scene;
    row["variant"] = cell.axes.empty() ? cell.precision : cell.precision + " " + cell.axes;
    row["point"] = cell.algorithm;
    row["stroke"] = cell.algorithm + " " + cell.table;
    return row;
}

ChartJson timed_row(const ReportCell& cell, const store::QueryTime& time, Omissions& omitted) {
    const measure::Figure ns = cell.figure(time.ns);
    if (!cell.verified() || !ns.value || *ns.value <= 0) {
        omitted.add(!cell.verified() ? fmt::format("the cell is {}: {}", cell.status, cell.reason)
                    : ns.value       ? "a time of 0"
                                     : ns.reason);
        return nullptr;
    }
    ChartJson row = curve_json(cell);
    row["ns"] = *ns.value;
    const measure::Figure low = cell.figure(time.low), high = cell.figure(time.high);
    row["low"] = low.value && *low.value > 0 ? *low.value : *ns.value;
    row["high"] = high.value && *high.value > 0 ? *high.value : *ns.value;
    return row;
}

ChartJson curve_layers(const ReportData& data, const ChartJson& values, const Curves& curves) {
    ChartJson layers = ChartJson::array();
    if (curves.has_interval) layers.push_back(interval_layer(curves));
    layers.push_back({{"transform", ChartJson::array({{{"filter", "!datum.unjoined"}}})},
                      {"mark", {{"type", "line"}, {"strokeWidth", 1.4}}},
                      {"encoding",
                       {{"y", curve_axis(curves.y)},
                        {"strokeDash", variant_dash(values)},
                        {"detail", {{"field", "stroke"}, {"type", "nominal"}}}}}});
    layers.push_back({{"mark", {{"type", "point"}, {"filled", true}}},
                      {"encoding",
                       {{"y", curve_axis(curves.y)},
                        {"shape", point_shape(data, values)},
                        {"size", {{"condition", {{"test", "datum.apart"}, {"value", 130}}}, {"value", 42}}},
                        {"tooltip", tooltip(curves)}}}});
    const char* const picks[] = {"layout", "variant", "point"};
    const std::size_t first = layers.size() == 3 ? 0 : 1;
    for (std::size_t i = first; i < 3; ++i)
        layers[i - first]["params"] = ChartJson::array({legend_pick(picks[i])});
    if (first == 1) layers[0]["params"].insert(layers[0]["params"].begin(), legend_pick(picks[0]));
    ChartJson all = curves.behind;
    all.push_back({{"encoding",
                    {{"x", curve_axis(curves.x)},
                     {"color", layout_colour(data)},
                     {"opacity", picked_opacity({"layout", "variant", "point"})}}},
                   {"layer", layers}});
    return {{"width", curves.width}, {"height", curves.height}, {"layer", all}};
}

ChartJson curve_spec(const ReportData& data, const ChartJson& values, const Curves& curves) {
    ChartJson spec{{"config", chart_config()}, {"data", {{"values", values}}}};
    spec.update(curve_layers(data, values, curves));
    return spec;
}

std::vector<ChartJson> span_layers(const CurveAxis& x_axis, double from, double to, int row,
                                   const std::string& label) {
    const ChartJson span{{x_axis.field, from}, {"span_end", to}, {"label", label}};
    const ChartJson data{{"values", ChartJson::array({span})}}, x = curve_axis(x_axis);
    const int height = 8 + 16 * row;
    const ChartJson bar{
        {"data", data},
        {"mark", {{"type", "rule"}, {"strokeWidth", 4}, {"color", "#b9c2cc"}}},
        {"encoding", {{"x", x}, {"x2", {{"field", "span_end"}}}, {"y", {{"value", height}}}}}};
    const ChartJson text{
        {"data", data},
        {"mark", {{"type", "text"}, {"align", "left"}, {"dy", 9}, {"fontSize", 9.5}, {"color", "#5a626c"}}},
        {"encoding",
         {{"x", x}, {"y", {{"value", height}}}, {"text", {{"field", "label"}, {"type", "nominal"}}}}}};
    return {bar, text};
}

}  // namespace edgewise::reports
