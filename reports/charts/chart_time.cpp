// SPDX-License-Identifier: MIT
//
// Times of separated and of overlapping pairs. Against vertices: log-log, one line per algorithm and table
// type, a row of panels per scene, separated pairs left and overlapping pairs right. And the ratio to the
// baseline as a heat map: a row per algorithm on a table type, a column a shape, a panel per scene; colour
// follows the logarithm, so half and double are equally far from white.
#include <algorithm>
#include <cmath>
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

/// Adds what `add_row` has to add of each verified cell and kind of pairs.
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

void ratio_add_row(const ReportCell& cell, PairKind kind, ChartRows& rows) {
    const auto ratio = rows.omitted.positive(cell.figure(times_of(kind).ratio),
                                             "a ratio of 0 has no logarithm", pair_name(kind) + " pairs: ");
    if (!ratio) return;
    ChartJson row = cell_json(cell);
    row["pairs"] = pair_name(kind);
    row["row"] = cell.algorithm + " " + cell.table;
    row["ratio"] = *ratio;
    // Two octaves each side are told apart by colour; the number in the cell says the rest.
    row["octaves"] = std::clamp(std::log2(*ratio), -2.0, 2.0);
    rows.values.push_back(std::move(row));
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

}  // namespace

Chart time_chart(const ReportData& data) {
    Chart chart = chart_of_file("time");
    ChartRows rows = rows_of_pairs(data, time_add_row);
    if (!take_rows(chart, rows)) return chart;
    fill_panels(data, rows.values);
    draw(chart, data, rows.values);
    return chart;
}

Chart ratio_chart(const ReportData& data) {
    ChartJson panels = ChartJson::array();
    // A panel per scene, each with the shapes and table types that it has.
    for (const std::string& scene : scene_labels(data))
        panels.push_back(ChartJson::object({{"scene", scene}}));
    return drawn_chart(chart_of_file("ratio"), data, rows_of_pairs(data, ratio_add_row),
                       {{"panels", panels}, {"rows", rows_in_order(data)}});
}

}  // namespace edgewise::reports
