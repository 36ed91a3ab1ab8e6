// SPDX-License-Identifier: MIT
//
// Time against vertices: log-log, one line an algorithm x table type, a row of panels a scene, separated
// pairs left and overlapping pairs right. The interval layer comes first and holds the layout's parameter: a
// composite error bar in its place would swallow legend clicks without a word.
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

void add_row(const ReportCell& cell, PairKind kind, ChartJson& values, Omissions& omitted) {
    const std::string pairs = pair_name(kind);
    const measure::Figure ns = cell.figure(times_of(kind).ns);
    if (!ns.value || *ns.value <= 0) {
        omitted.add(pairs +
                    " pairs: " + (ns.value ? "a time of 0 has no place on a logarithmic axis" : ns.reason));
        return;
    }
    ChartJson row = cell_json(cell);
    row["pairs"] = pairs;
    // Sizes of one family are joined by a line; a mesh is a point of its own.
    row["family"] = cell.shape_source == "built-in";
    row["ns"] = *ns.value;
    const measure::Figure low = cell.figure(times_of(kind).low), high = cell.figure(times_of(kind).high);
    row["low"] = low.value && *low.value > 0 ? *low.value : *ns.value;
    row["high"] = high.value && *high.value > 0 ? *high.value : *ns.value;
    values.push_back(std::move(row));
}

/// Panels stand in rows and columns only if each has a row of data, if an empty one: else those that follow
/// move up.
void fill_panels(const ReportData& data, ChartJson& values) {
    std::set<std::pair<std::string, std::string>> present;
    std::set<std::string> scenes;
    for (const ChartJson& row : values) {
        present.emplace(row["scene"].get<std::string>(), row["pairs"].get<std::string>());
        scenes.insert(row["scene"].get<std::string>());
    }
    for (const std::string& scene : scene_labels(data)) {
        for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping}) {
            if (scenes.count(scene) && !present.count({scene, pair_name(kind)}))
                values.push_back(
                    ChartJson::object({{"scene", scene}, {"pairs", pair_name(kind)}, {"ns", nullptr}}));
        }
    }
}

ChartJson tooltip() {
    ChartJson fields = ChartJson::array();
    for (const char* name : {"table", "algorithm", "scene", "shape", "vertices", "pairs"})
        fields.push_back({{"field", name}, {"type", "nominal"}});
    for (const char* name : {"ns", "low", "high"})
        fields.push_back({{"field", name}, {"type", "quantitative"}, {"format", ".4~g"}});
    return fields;
}

ChartJson axis(const char* field, const char* title) {
    return {{"field", field}, {"type", "quantitative"}, {"title", title}, {"scale", log_scale()}};
}

ChartJson shared_encoding(const ReportData& data) {
    ChartJson x = axis("vertices", "vertices of a body");
    x["axis"] = {{"format", "~s"}, {"tickCount", 6}};
    return {{"x", x},
            {"color", layout_colour(data)},
            {"opacity", picked_opacity({"layout", "algorithm", "precision"})}};
}

ChartJson interval_layer() {
    return {{"params", ChartJson::array({legend_pick("layout")})},
            {"mark", {{"type", "rule"}, {"strokeWidth", 2}}},
            {"encoding", {{"y", axis("low", "ns a query, median")}, {"y2", {{"field", "high"}}}}}};
}

ChartJson line_layer(const ReportData& data) {
    return {{"params", ChartJson::array({legend_pick("precision")})},
            {"transform", ChartJson::array({{{"filter", "datum.family"}}})},
            {"mark", {{"type", "line"}, {"strokeWidth", 1.4}}},
            {"encoding",
             {{"y", axis("ns", "ns a query, median")},
              {"strokeDash", precision_dash(data)},
              {"detail", {{"field", "algorithm"}, {"type", "nominal"}}}}}};
}

ChartJson point_layer(const ReportData& data) {
    return {{"params", ChartJson::array({legend_pick("algorithm")})},
            {"mark", {{"type", "point"}, {"filled", true}, {"size", 42}}},
            {"encoding",
             {{"y", axis("ns", "ns a query, median")},
              {"shape", algorithm_shape(data)},
              {"tooltip", tooltip()}}}};
}

}  // namespace

Chart time_chart(const ReportData& data) {
    Chart chart{
        "time",
        "Time against vertices",
        "Each line is an algorithm on a table type over the sizes of the built-in shapes; meshes are single "
        "points. Lower is faster; both axes are logarithmic and the bars are bootstrap 95 % intervals. Click "
        "a layout, an algorithm or a precision in the legend to dim the rest, shift-click to add another, "
        "click an empty place to show all.",
        nullptr,
        {},
        {}};
    ChartJson values = ChartJson::array();
    Omissions omitted;
    for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping})
        for (const ReportCell& cell : data.cells)
            if (cell.verified()) add_row(cell, kind, values, omitted);
    omitted.write("cell", chart.notes);
    thin(values, mark_limit / 3, chart.notes);
    if (values.empty()) return chart;
    chart.fallback =
        data_grid(values, {"scene", "pairs", "shape", "vertices", "algorithm", "table", "ns", "low", "high"});
    fill_panels(data, values);
    const ChartJson pairs{
        {"field", "pairs"}, {"type", "nominal"}, {"title", nullptr}, {"sort", {"separated", "overlapping"}}};
    chart.spec = {{"config", chart_config()},
                  {"data", {{"values", values}}},
                  {"facet", {{"row", scene_rows(data)}, {"column", pairs}}},
                  {"spec",
                   {{"width", 400},
                    {"height", 300},
                    {"encoding", shared_encoding(data)},
                    {"layer", ChartJson::array({interval_layer(), line_layer(data), point_layer(data)})}}}};
    return chart;
}

}  // namespace edgewise::reports
