// SPDX-License-Identifier: MIT
//
// Ratio to the baseline as a heat map: a row per algorithm on a table type, a column a shape, a panel per
// scene. Colour follows the logarithm, so half and double are equally far from white.
#include <algorithm>
#include <cmath>
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

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

Chart ratio_chart(const ReportData& data) {
    ChartRows rows;
    ChartJson panels = ChartJson::array();
    for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping})
        for (const ReportCell& cell : data.cells)
            if (cell.verified()) ratio_add_row(cell, kind, rows);
    // A panel per scene, each with the shapes and table types that it has.
    for (const std::string& scene : scene_labels(data))
        panels.push_back(ChartJson::object({{"scene", scene}}));
    return drawn_chart(chart_of_file("ratio"), data, std::move(rows),
                       {{"panels", panels}, {"rows", rows_in_order(data)}});
}

}  // namespace edgewise::reports
