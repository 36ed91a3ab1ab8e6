// SPDX-License-Identifier: MIT
//
// Bytes per edge by component: one bar per table type, one panel per algorithm, one shape at a time.
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/palette.hpp"

namespace edgewise::reports {

namespace {

/// One row per component, once for each algorithm, table type and shape.
ChartRows component_rows(const ReportData& data, const std::vector<std::string>& components) {
    ChartRows rows;
    std::set<std::string> seen;
    for (const ReportCell* verified : verified_cells(data)) {
        const ReportCell& cell = *verified;
        if (!seen.insert(cell.algorithm + '\n' + cell.table + '\n' + cell.shape).second) continue;
        for (std::size_t i = 0; i < components.size(); ++i) {
            const measure::Figure figure = cell.figure("bytes", components[i]);
            if (!figure.value) {
                rows.omitted.add(in_words(components[i]) + ": " + figure.reason);
                continue;
            }
            ChartJson row = cell_json(cell);
            row["component"] = in_words(components[i]);
            row["order"] = i;
            row["bytes"] = *figure.value;
            row["total"] = cell.figure("bytes.total_bytes_per_edge").value.value_or(0);
            rows.values.push_back(std::move(row));
        }
    }
    return rows;
}

/// Returns one panel for each algorithm, with its own table types.
ChartJson panels_of(const ReportData& data, const ChartJson& pick) {
    ChartJson panels = ChartJson::array();
    // A parameter lives in one panel; the others refer to it by name.
    for (const std::string& algorithm : algorithm_names(data))
        panels.push_back({{"algorithm", algorithm},
                          {"picks", panels.empty() ? ChartJson::array({pick}) : ChartJson::array()}});
    return panels;
}

ChartJson bytes_slots_of(const ReportData& data, const std::vector<std::string>& components,
                         const ChartJson& pick) {
    ChartJson names = ChartJson::array(), colours = ChartJson::array();
    for (std::size_t i = 0; i < components.size(); ++i) {
        names.push_back(in_words(components[i]));
        colours.push_back(store::component_colour(components[i], i));
    }
    return {{"components", names},
            {"component_colours", colours},
            {"reference_shape", reference_shape(data)},
            {"panels", panels_of(data, pick)}};
}

}  // namespace

Chart bytes_chart(const ReportData& data) {
    Chart chart = chart_of_file("bytes");
    const auto components = byte_components(data);
    ChartRows rows = component_rows(data, components);
    if (!take_rows(chart, rows, "component bar")) return chart;
    ChartJson shown = ChartJson::array();
    for (const ChartJson& row : rows.values)
        if (row["shape"] == reference_shape(data)) shown.push_back(row);
    chart.fallback = data_grid(shown, chart.file["fallback"]);
    draw(chart, data, rows.values, bytes_slots_of(data, components, chart.file["parts"]["component_pick"]));
    return chart;
}

}  // namespace edgewise::reports
