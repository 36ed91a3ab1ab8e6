// SPDX-License-Identifier: MIT
//
// Speed against error: what accuracy a nanosecond buys. Log-log; an error of exactly 0 has no place on a
// logarithmic axis, so it is drawn on a labelled floor one decade or more below the smallest error.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

void add_row(const ReportCell& cell, ChartJson& values, Omissions& omitted) {
    const measure::Figure ns = cell.figure("time.separated_ns");
    const measure::Figure error = cell.figure("error.worst_error_given");
    if (!ns.value || *ns.value <= 0) {
        omitted.add("time: " + (ns.value ? "a time of 0 has no place on a logarithmic axis" : ns.reason));
    } else if (!error.value) {
        omitted.add("error: " + error.reason);
    } else {
        ChartJson row = cell_json(cell);
        row["ns"] = *ns.value;
        row["error"] = *error.value;
        values.push_back(std::move(row));
    }
}

/// A whole power of ten below every positive error; writes "drawn", the place on the axis, into each row.
double place_on_axis(ChartJson& values) {
    double least = 1e-15;
    for (const ChartJson& row : values)
        if (row["error"] > 0) least = std::min(least, row["error"].get<double>());
    double floor = 1e-15;
    while (floor > least / 10 && floor > 1e-300) floor /= 10;
    for (ChartJson& row : values) row["drawn"] = row["error"] > 0 ? row["error"].get<double>() : floor;
    return floor;
}

/// Even powers of ten among the errors, and the floor where something stands on it. A tick beyond the data
/// would be drawn beside the panel.
ChartJson ticks(const ChartJson& values, double floor) {
    double least = 1e300, largest = 0;
    ChartJson places = ChartJson::array();
    for (const ChartJson& row : values) {
        if (row["error"] == 0 && places.empty()) places.push_back(floor);
        if (row["error"] > 0) least = std::min(least, row["error"].get<double>());
        largest = std::max(largest, row["error"].get<double>());
    }
    for (int power = -300; power <= 300; power += 2) {
        // Read from text: a product of tens would miss the decimal value by a rounding.
        const double place = std::stod(fmt::format("1e{}", power));
        if (place >= (places.empty() ? least : 10 * floor) && place <= largest) places.push_back(place);
    }
    return places;
}

ChartJson tooltip() {
    ChartJson fields = ChartJson::array();
    for (const char* name : {"table", "algorithm", "scene", "shape", "vertices"})
        fields.push_back({{"field", name}, {"type", "nominal"}});
    fields.push_back({{"field", "ns"}, {"type", "quantitative"}, {"format", ".4~g"}});
    fields.push_back({{"field", "error"}, {"type", "quantitative"}, {"format", ".2~e"}});
    return fields;
}

ChartJson point_layer(const ReportData& data, double floor, const ChartJson& places) {
    const std::string label =
        fmt::format("datum.value < {:g} ? 'exactly 0' : format(datum.value, '.0e')", floor * 2);
    return {{"params", ChartJson::array({legend_pick("layout"), legend_pick("algorithm")})},
            {"mark", {{"type", "point"}, {"filled", true}, {"size", 55}}},
            {"encoding",
             {{"x",
               {{"field", "drawn"},
                {"type", "quantitative"},
                {"title", "worst error / scale"},
                {"scale", log_scale()},
                {"axis", {{"labelExpr", label}, {"values", places}}}}},
              {"y",
               {{"field", "ns"},
                {"type", "quantitative"},
                {"title", "ns a query, separated pairs"},
                {"scale", log_scale()}}},
              {"color", layout_colour(data)},
              {"shape", algorithm_shape(data)},
              {"opacity", picked_opacity({"layout", "algorithm"})},
              {"tooltip", tooltip()}}}};
}

ChartJson floor_layer(double floor) {
    return {{"data", {{"values", ChartJson::array({{{"drawn", floor}}})}}},
            {"mark", {{"type", "rule"}, {"strokeDash", {2, 3}}, {"color", "#777"}}},
            {"encoding", {{"x", {{"field", "drawn"}, {"type", "quantitative"}}}}}};
}

}  // namespace

Chart speed_error_chart(const ReportData& data) {
    Chart chart{"speed_error",
                "Speed against error",
                "Each point is a cell: left is more exact, low is faster, so the lower left corner wins. The "
                "error is "
                "the worst |d - d*| over the scale of the pair, against the exact distance of the bodies as "
                "given, so "
                "it includes what the table's rounding costs.",
                nullptr,
                {},
                {}};
    ChartJson values = ChartJson::array();
    Omissions omitted;
    for (const ReportCell& cell : data.cells)
        if (cell.verified()) add_row(cell, values, omitted);
    omitted.write("cell", chart.notes);
    thin(values, mark_limit, chart.notes);
    if (values.empty()) return chart;
    const double floor = place_on_axis(values);
    ChartJson layers = ChartJson::array();
    const auto zeros =
        std::count_if(values.begin(), values.end(), [](const auto& row) { return row["error"] == 0; });
    if (zeros > 0) {
        layers.push_back(floor_layer(floor));
        chart.notes.push_back(fmt::format(
            "{} of {} points have an error of exactly 0: they stand on the dotted line at the left edge, "
            "whose place on the axis means nothing.",
            zeros, values.size()));
    }
    layers.push_back(point_layer(data, floor, ticks(values, floor)));
    chart.spec = {
        {"config", chart_config()},
        {"data", {{"values", values}}},
        {"facet",
         {{"field", "scene"}, {"type", "nominal"}, {"title", nullptr}, {"sort", scene_labels(data)}}},
        {"columns", 2},
        {"spec", {{"width", 400}, {"height", 300}, {"layer", layers}}}};
    chart.fallback = data_grid(values, {"scene", "shape", "algorithm", "table", "ns", "error"});
    return chart;
}

}  // namespace edgewise::reports
