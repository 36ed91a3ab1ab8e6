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

void add_times(ChartRows& rows, const StoredScene& scene, const char* measure) {
    add_timed_rows(rows, scene.cells, [&](const ReportCell& cell) -> ChartJson {
        return {{"measure", measure}, {"value", cell.figure(store::all_time.ns).value.value_or(0)}};
    });
    for (ChartJson& row : rows.values) row.erase("ns");
}

void add_bytes(ChartRows& rows, const StoredScene& scene) {
    for (const ReportCell* cell : scene.cells) {
        const auto size = rows.omitted.positive(cell->figure("bytes.table_bytes"), "a size of 0");
        if (!size) continue;
        ChartJson row = curve_json(*cell);
        row["measure"] = bytes;
        row["value"] = row["low"] = row["high"] = *size;  // a size is exact
        rows.values.push_back(std::move(row));
    }
}

}  // namespace

Chart paper_complexity_chart(const ReportData& data) {
    ChartRows rows;
    const StoredScene scene = scene_file(data, "paper_complexity");
    add_times(rows, scene, warm);
    add_times(rows, scene_file(data, "paper_cold"), cold);
    add_bytes(rows, scene);
    return drawn_chart(chart_of_file("paper_complexity"), data, std::move(rows),
                       {{"measures", {warm, cold, bytes}}});
}

}  // namespace edgewise::reports
