// SPDX-License-Identifier: MIT
//
// Page faults a query against the memory that tables have: measured under limits (points) and predicted by
// the page-granular reuse distance (line), in one plot.
#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/chapter/paging_limits.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

ChartJson row_of(const ReportCell& cell, double memory, const char* kind, double faults) {
    ChartJson row = curve_json(cell);
    row["memory"] = memory;
    row["kind"] = kind;
    row["faults"] = faults;
    return row;
}

/// A limit's two places on the predicted line, and its measured point.
void add_limit(const ReportCell& cell, const PagingLimit& limit, Omissions& omitted, ChartJson& values) {
    const double held = limit.held.value.value_or(0), given = limit.limit.value.value_or(0);
    if (held > 0 && limit.predicted_at_held.value)
        values.push_back(row_of(cell, held, "predicted", *limit.predicted_at_held.value));
    if (given > 0 && limit.predicted_at_limit.value)
        values.push_back(row_of(cell, given, "predicted", *limit.predicted_at_limit.value));
    if (held > 0 && limit.faults.value)
        values.push_back(row_of(cell, held, "measured", *limit.faults.value));
    else
        omitted.add(limit.faults.value ? limit.held.reason : limit.faults.reason);
}

ChartJson layer(const ReportData& data, const char* kind, const ChartJson& mark) {
    ChartJson layer{{"transform", ChartJson::array({equal_filter("kind", kind)})},
                    {"mark", mark},
                    {"encoding", {{"opacity", picked_opacity({"layout", "algorithm"})}}}};
    if (mark["type"] == "line") {
        layer["params"] = ChartJson::array({legend_pick("layout")});
        layer["encoding"]["strokeDash"] = precision_dash(data);
        layer["encoding"]["detail"] = {{"field", "stroke"}, {"type", "nominal"}};
    } else {
        layer["params"] = ChartJson::array({legend_pick("algorithm")});
        layer["encoding"]["shape"] = algorithm_shape(data);
    }
    return layer;
}

ChartJson spec_of(const ReportData& data, const ChartJson& values) {
    ChartJson tooltip = ChartJson::array();
    for (const char* name : {"kind", "table", "algorithm", "shape"})
        tooltip.push_back({{"field", name}, {"type", "nominal"}});
    for (const char* name : {"memory", "faults"})
        tooltip.push_back({{"field", name}, {"type", "quantitative"}, {"format", ".4~g"}});
    const ChartJson encoding{{"x", curve_axis(bytes_axis("memory", "memory for the tables"))},
                             {"y", curve_axis({"faults", "page faults a query", scale_with_zero(0.01),
                                               ticks_at({0, 0.01, 0.1, 1, 10, 100})})},
                             {"color", layout_colour(data)},
                             {"tooltip", tooltip}};
    const ChartJson line = layer(data, "predicted", {{"type", "line"}, {"strokeWidth", 1.4}});
    const ChartJson point = layer(data, "measured", {{"type", "point"}, {"filled", true}, {"size", 60}});
    return {{"config", chart_config()},
            {"data", {{"values", values}}},
            {"facet", {{"field", "shape"}, {"type", "nominal"}, {"title", nullptr}}},
            {"columns", 2},
            {"spec",
             {{"width", 460},
              {"height", 320},
              {"encoding", encoding},
              {"layer", ChartJson::array({line, point})}}}};
}

}  // namespace

Chart paper_paging_chart(const ReportData& data) {
    Chart chart{
        "paper_thrash_paging",
        "Page faults against memory, measured and predicted",
        "Points: major page faults a query, measured on this machine under a memory limit, at the memory "
        "that the limit left to the tables. Lines: what the page-granular reuse distance predicts for an "
        "LRU memory of that size. Memory is logarithmic, faults are linear below 0.01 so that none has "
        "its place. Where points and line rise is where a machine of 2001 with that much memory to spare "
        "began to swap.",
        nullptr,
        {},
        {},
        data.scene_files.empty() ? "" : thrash_section};
    Omissions omitted;
    ChartJson values = ChartJson::array();
    bool keeps_recency = true;
    for (const ReportCell& row : data.paging) {
        keeps_recency = keeps_recency && row.figure("paging.keeps_recency").value.value_or(1) != 0;
        for (const PagingLimit& limit : paging_limits(row)) add_limit(row, limit, omitted, values);
    }
    if (values.empty()) return chart;
    omitted.write("limit", chart.notes);
    if (!keeps_recency)
        chart.notes.emplace_back(
            "The system could throw out any page, not the least recent (read-ahead could not be set), so "
            "measured faults need not follow the line.");
    chart.spec = spec_of(data, values);
    chart.fallback = data_grid(values, {"shape", "algorithm", "table", "kind", "memory", "faults"});
    return chart;
}

}  // namespace edgewise::reports
