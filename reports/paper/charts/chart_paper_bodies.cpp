// SPDX-License-Identifier: MIT
//
// Figure 5 of the paper: tests of pairs against bodies, at constant occupancy. The number of tests does not
// depend on algorithm or table, so a scene is one line.
#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

#include <map>

namespace edgewise::reports {

namespace {

struct Series {
    const char *scene, *label;
};
constexpr Series measured[] = {{"paper_bodies", "the environment grows"},
                               {"paper_bodies_shrinking", "the bodies shrink"}};
constexpr const char *all_pairs = "all pairs, n(n-1)/2", *papers_end = "the paper's end: 600, 300";

/// Bodies -> tests per step, as any of the cells has counted them.
std::map<double, double> tests_of(const StoredScene& scene, Omissions& omitted) {
    std::map<double, double> tests;
    for (const ReportCell* cell : scene.cells) {
        const auto bodies = scene_number(*cell, "bodies");
        const measure::Figure pairs = cell->figure("cost.pairs_per_step");
        if (!bodies || !pairs.value || *pairs.value <= 0)
            omitted.add(pairs.value ? "no pair was tested, which a logarithmic axis cannot show"
                                    : pairs.reason);
        else
            tests.emplace(*bodies, *pairs.value);
    }
    return tests;
}

ChartJson bodies_row(const std::string& series, double bodies, double tests) {
    return {{"series", series}, {"bodies", bodies}, {"tests", tests}, {"alone", series == papers_end}};
}

ChartJson bodies_values_of(const ReportData& data, Omissions& omitted) {
    ChartJson values = ChartJson::array();
    std::map<double, double> pairs;
    for (const Series& series : measured) {
        for (const auto& [bodies, tests] : tests_of(scene_file(data, series.scene), omitted)) {
            values.push_back(bodies_row(series.label, bodies, tests));
            pairs[bodies] = bodies * (bodies - 1) / 2;
        }
    }
    if (values.empty()) return values;
    for (const auto& [bodies, count] : pairs) values.push_back(bodies_row(all_pairs, bodies, count));
    values.push_back(bodies_row(papers_end, 600, 300));
    return values;
}

}  // namespace

Chart paper_bodies_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_bodies");
    chart.name = "paper_figure_5";
    Omissions omitted;
    ChartJson values = bodies_values_of(data, omitted);
    if (take_rows(chart, values, omitted))
        draw(chart, data, values,
             {{"series", {measured[0].label, measured[1].label, all_pairs, papers_end}}});
    return chart;
}

}  // namespace edgewise::reports
