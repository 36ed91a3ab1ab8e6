// SPDX-License-Identifier: MIT
//
// The paper's scalability in complexity: time and memory against the vertices of a body. Panels: coherent
// queries, cold ones (hill climbing from anywhere), bytes of a table.
#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

constexpr const char *warm = "ns a query", *cold = "ns a cold query", *bytes = "bytes of a table";

void add_times(const StoredScene& scene, const char* measure, Omissions& omitted, ChartJson& values) {
    for (const ReportCell* cell : scene.cells) {
        ChartJson row = timed_row(*cell, store::all_time, omitted);
        if (row.is_null()) continue;
        row["measure"] = measure;
        row["value"] = row["ns"];
        row.erase("ns");
        values.push_back(std::move(row));
    }
}

void add_bytes(const StoredScene& scene, Omissions& omitted, ChartJson& values) {
    for (const ReportCell* cell : scene.cells) {
        const measure::Figure size = cell->figure("bytes.table_bytes");
        if (!size.value || *size.value <= 0) {
            omitted.add(size.reason);
            continue;
        }
        ChartJson row = curve_json(*cell);
        row["measure"] = bytes;
        row["value"] = row["low"] = row["high"] = *size.value;  // a size is exact
        values.push_back(std::move(row));
    }
}

ChartJson spec_of(const ReportData& data, const ChartJson& values) {
    Curves curves;
    curves.x = {"vertices", "vertices of a body", log_scale(), {{"format", "~s"}, {"tickCount", 6}}};
    curves.y = {"value", "", log_scale(), {{"format", "~s"}, {"tickCount", 6}}};
    curves.width = 320;
    curves.height = 280;
    const ChartJson facet{
        {"field", "measure"}, {"type", "nominal"}, {"title", nullptr}, {"sort", {warm, cold, bytes}}};
    return {{"config", chart_config()},
            {"data", {{"values", values}}},
            {"facet", facet},
            {"columns", 3},
            {"resolve", {{"scale", {{"y", "independent"}}}}},
            {"spec", curve_layers(data, values, curves)}};
}

}  // namespace

Chart paper_complexity_chart(const ReportData& data) {
    Chart chart{
        "paper_complexity",
        "Time and memory against complexity",
        "Median time of a query, with its 95 % interval, and bytes of one body's table, against the "
        "vertices of a body; all axes are logarithmic. Cold queries start anywhere: there hill climbing "
        "shows what it costs, where coherence otherwise hides it. The paper says that both algorithms "
        "scale as expected, hill climbing as O(log n), and that V-Clip's Voronoi regions take 168 bytes "
        "an edge in double precision.",
        nullptr,
        {},
        {},
        scalability_section};
    Omissions omitted;
    ChartJson values = ChartJson::array();
    const StoredScene scene = scene_file(data, "paper_complexity");
    add_times(scene, warm, omitted, values);
    add_times(scene_file(data, "paper_cold"), cold, omitted, values);
    add_bytes(scene, omitted, values);
    if (values.empty()) return chart;
    omitted.write("cell", chart.notes);
    chart.spec = spec_of(data, values);
    chart.fallback = data_grid(values, {"measure", "shape", "vertices", "algorithm", "table", "value"});
    return chart;
}

}  // namespace edgewise::reports
