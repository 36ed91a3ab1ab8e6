// SPDX-License-Identifier: MIT
//
// Time against vertices: log-log, one line per algorithm and table type, a row of panels per scene, separated
// pairs left and overlapping pairs right.
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

void time_add_row(const ReportCell& cell, PairKind kind, ChartJson& values, Omissions& omitted) {
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

}  // namespace

Chart time_chart(const ReportData& data) {
    Chart chart = chart_of_file("time");
    ChartJson values = ChartJson::array();
    Omissions omitted;
    for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping})
        for (const ReportCell& cell : data.cells)
            if (cell.verified()) time_add_row(cell, kind, values, omitted);
    if (!take_rows(chart, values, omitted)) return chart;
    fill_panels(data, values);
    draw(chart, data, values);
    return chart;
}

}  // namespace edgewise::reports
