// SPDX-License-Identifier: MIT
//
// The paper's scalability in complexity: time and memory against the vertices of a body. Panels: coherent
// queries, cold ones (hill climbing from any vertex), bytes of a table.
#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

constexpr const char *warm = "ns per query", *cold = "ns per cold query", *bytes = "bytes of a table";

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

}  // namespace

Chart paper_complexity_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_complexity");
    Omissions omitted;
    ChartJson values = ChartJson::array();
    const StoredScene scene = scene_file(data, "paper_complexity");
    add_times(scene, warm, omitted, values);
    add_times(scene_file(data, "paper_cold"), cold, omitted, values);
    add_bytes(scene, omitted, values);
    if (take_rows(chart, values, omitted)) draw(chart, data, values, {{"measures", {warm, cold, bytes}}});
    return chart;
}

}  // namespace edgewise::reports
