// SPDX-License-Identifier: MIT
//
// Times of separated and of overlapping pairs against vertices: log-log, one line per algorithm and table
// type, of the scene that is chosen, separated pairs left and overlapping pairs right.
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

/// Adds the rows of `add_row` for each verified cell and kind of pairs.
ChartRows rows_of_pairs(const ReportData& data, void (*add_row)(const ReportCell&, PairKind, ChartRows&)) {
    ChartRows rows;
    for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping})
        for (const ReportCell* cell : verified_cells(data)) add_row(*cell, kind, rows);
    return rows;
}

void time_add_row(const ReportCell& cell, PairKind kind, ChartRows& rows) {
    const store::QueryTime& times = times_of(kind);
    const char* const when_zero = "a time of 0 has no place on a logarithmic axis";
    if (!rows.omitted.positive(cell.figure(times.ns), when_zero, pair_name(kind) + " pairs: ")) return;
    ChartJson row = cell_json(cell);
    row["pairs"] = pair_name(kind);
    // Sizes of one family are joined by a line; a mesh is a point of its own.
    row["family"] = cell.shape_source == "built-in";
    add_time(row, cell, times);
    rows.values.push_back(std::move(row));
}

/// Panels keep their rows and columns only if each has a row of data, even an empty one: else later panels
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

}  // namespace

Chart time_chart(const ReportData& data) {
    Chart chart = chart_of_file("time");
    ChartRows rows = rows_of_pairs(data, time_add_row);
    if (!take_rows(chart, rows)) return chart;
    const ChartJson scenes = scenes_of_rows(data, rows.values);
    fill_panels(data, rows.values);
    draw(chart, data, rows.values, scene_slots(scenes));
    return chart;
}

}  // namespace edgewise::reports
