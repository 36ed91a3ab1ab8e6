// SPDX-License-Identifier: MIT
//
// The paper's scalability. Figure 5: tests of pairs against bodies, at constant occupancy; the number of
// tests does not depend on algorithm or table, so a scene is one line. In complexity: time and memory against
// the vertices of a body, in panels: coherent queries, cold ones (hill climbing from any vertex), bytes of a
// table.
#include <map>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

struct Series {
    const char *scene, *label;
};
constexpr Series measured_series[] = {{"paper_bodies", "the environment grows"},
                                      {"paper_bodies_shrinking", "the bodies shrink"}};
constexpr const char *all_pairs = "all pairs, n(n-1)/2", *papers_end = "the paper's end: 600, 300";

/// Bodies -> tests per step, as any of the cells has counted them.
std::map<double, double> tests_of(const StoredScene& scene, Omissions& omitted) {
    std::map<double, double> tests;
    for (const ReportCell* cell : scene.cells) {
        const auto bodies = scene_number(*cell, "bodies");
        const auto pairs = omitted.positive(cell->figure("cost.pairs_per_step"),
                                            "no pair was tested, which a logarithmic axis cannot show");
        if (bodies && pairs) tests.emplace(*bodies, *pairs);
    }
    return tests;
}

/// `scene`: null for what is not measured.
ChartJson bodies_row(const ChartJson& scene, const std::string& series, double bodies, double tests) {
    return {{"scene", scene},
            {"series", series},
            {"bodies", bodies},
            {"tests", tests},
            {"alone", series == papers_end}};
}

ChartRows bodies_rows(const ReportData& data) {
    ChartRows rows;
    std::map<double, double> pairs;
    for (const Series& series : measured_series) {
        for (const auto& [bodies, tests] : tests_of(scene_file(data, series.scene), rows.omitted)) {
            rows.values.push_back(bodies_row(series.scene, series.label, bodies, tests));
            pairs[bodies] = bodies * (bodies - 1) / 2;
        }
    }
    if (rows.values.empty()) return rows;
    for (const auto& [bodies, count] : pairs)
        rows.values.push_back(bodies_row(nullptr, all_pairs, bodies, count));
    rows.values.push_back(bodies_row(nullptr, papers_end, 600, 300));
    return rows;
}

constexpr const char *of_warm = "ns per query", *of_cold = "ns per cold query",
                     *of_bytes = "bytes of a table";

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
        row["measure"] = of_bytes;
        row["value"] = row["low"] = row["high"] = *size;  // a size is exact
        rows.values.push_back(std::move(row));
    }
}

}  // namespace

Chart paper_bodies_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_bodies");
    number_chart(chart, 5);
    return drawn_chart(
        std::move(chart), data, bodies_rows(data),
        {{"series", {measured_series[0].label, measured_series[1].label, all_pairs, papers_end}}});
}

Chart paper_complexity_chart(const ReportData& data) {
    ChartRows rows;
    const StoredScene scene = scene_file(data, "paper_complexity");
    add_times(rows, scene, of_warm);
    add_times(rows, scene_file(data, "paper_cold"), of_cold);
    add_bytes(rows, scene);
    return drawn_chart(chart_of_file("paper_complexity"), data, std::move(rows),
                       {{"measures", {of_warm, of_cold, of_bytes}}});
}

}  // namespace edgewise::reports
