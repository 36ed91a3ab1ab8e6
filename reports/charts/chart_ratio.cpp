// SPDX-License-Identifier: MIT
//
// Ratio to the baseline as a heat map: a row an algorithm on a table type, a column a shape, a panel a scene.
// Colour follows the logarithm, so half and double are equally far from white.
#include <algorithm>
#include <cmath>
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

void add_row(const ReportCell& cell, PairKind kind, ChartJson& values, Omissions& omitted) {
    const measure::Figure ratio = cell.figure(times_of(kind).ratio);
    if (!ratio.value || *ratio.value <= 0) {
        omitted.add(pair_name(kind) +
                    " pairs: " + (ratio.value ? "a ratio of 0 has no logarithm" : ratio.reason));
        return;
    }
    ChartJson row = cell_json(cell);
    row["pairs"] = pair_name(kind);
    row["row"] = cell.algorithm + " " + cell.table;
    row["ratio"] = *ratio.value;
    // Two octaves each side are told apart by colour; the number in the cell says the rest.
    row["octaves"] = std::clamp(std::log2(*ratio.value), -2.0, 2.0);
    values.push_back(std::move(row));
}

ChartJson shapes_by_size(const ReportData& data) {
    std::set<std::pair<std::int64_t, std::string>> shapes;
    for (const ReportCell& cell : data.cells) shapes.emplace(cell.vertices, cell.shape);
    ChartJson names = ChartJson::array();
    for (const auto& [vertices, name] : shapes)
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    return names;
}

/// "vclip aos_f64": algorithms in the order of all charts, then table types by name.
ChartJson rows_in_order(const ReportData& data) {
    ChartJson rows = ChartJson::array();
    for (const std::string& algorithm : algorithm_names(data)) {
        std::set<std::string> tables;
        for (const ReportCell& cell : data.cells)
            if (cell.algorithm == algorithm) tables.insert(cell.table);
        for (const std::string& table : tables) rows.push_back(algorithm + " " + table);
    }
    return rows;
}

ChartJson tooltip() {
    ChartJson fields = ChartJson::array();
    for (const char* name : {"table", "algorithm", "scene", "shape", "vertices", "pairs"})
        fields.push_back({{"field", name}, {"type", "nominal"}});
    fields.push_back({{"field", "ratio"}, {"type", "quantitative"}, {"format", ".3f"}});
    return fields;
}

ChartJson colour_layer() {
    return {{"mark", {{"type", "rect"}, {"stroke", "white"}}},
            {"encoding",
             {{"color",
               {{"field", "octaves"},
                {"type", "quantitative"},
                {"title", "time / baseline"},
                {"scale", {{"scheme", "blueorange"}, {"domain", {-2, 2}}, {"clamp", true}}},
                {"legend",
                 {{"labelExpr", "format(pow(2, datum.value), '.3~g')"},
                  {"gradientLength", 160},
                  {"values", {-2, -1, 0, 1, 2}}}}}},
              {"tooltip", tooltip()}}}};
}

ChartJson number_layer() {
    const ChartJson dark{{"test", "abs(datum.octaves) > 1.5"}, {"value", "white"}};
    return {{"mark", {{"type", "text"}, {"fontSize", 9.5}}},
            {"encoding",
             {{"text", {{"field", "ratio"}, {"type", "quantitative"}, {"format", ".2f"}}},
              {"color", {{"condition", dark}, {"value", "#222"}}}}}};
}

/// A panel a scene, two in a line, each with the shapes and table types that it has.
ChartJson panels(const ReportData& data) {
    const ChartJson x{{"field", "shape"},
                      {"type", "nominal"},
                      {"title", nullptr},
                      {"sort", shapes_by_size(data)},
                      {"axis", {{"labelAngle", -40}}}};
    const ChartJson y{
        {"field", "row"}, {"type", "nominal"}, {"title", nullptr}, {"sort", rows_in_order(data)}};
    ChartJson list = ChartJson::array();
    for (const std::string& scene : scene_labels(data))
        list.push_back({{"title", {{"text", scene}, {"fontSize", 12}}},
                        {"transform", ChartJson::array({equal_filter("scene", scene)})},
                        {"width", {{"step", 42}}},
                        {"height", {{"step", 17}}},
                        {"encoding", {{"x", x}, {"y", y}}},
                        {"layer", ChartJson::array({colour_layer(), number_layer()})}});
    return list;
}

ChartJson pairs_choice() {
    return {{"name", "shown_pairs"},
            {"value", "separated"},
            {"bind", {{"input", "select"}, {"options", {"separated", "overlapping"}}, {"name", "Pairs: "}}}};
}

}  // namespace

Chart ratio_chart(const ReportData& data) {
    Chart chart{
        "ratio",
        "Time relative to the baseline",
        "Each number is the median over rounds of the cell's time over that of the baseline (V-Clip on "
        "aos_f64, same scene and shape) timed in the same round. Below 1 (blue) is faster than the baseline, "
        "above 1 (orange) slower; an empty place was not measured. Choose the kind of pair below the chart.",
        nullptr,
        {},
        {}};
    ChartJson values = ChartJson::array();
    Omissions omitted;
    for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping})
        for (const ReportCell& cell : data.cells)
            if (cell.verified()) add_row(cell, kind, values, omitted);
    omitted.write("cell", chart.notes);
    thin(values, mark_limit / 2, chart.notes);
    if (values.empty()) return chart;
    chart.spec = {{"config", chart_config()},
                  {"params", ChartJson::array({pairs_choice()})},
                  {"data", {{"values", values}}},
                  {"transform", ChartJson::array({{{"filter", "datum.pairs === shown_pairs"}}})},
                  {"concat", panels(data)},
                  {"columns", 2}};
    chart.fallback = data_grid(values, {"scene", "pairs", "shape", "algorithm", "table", "ratio"});
    return chart;
}

}  // namespace edgewise::reports
