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

/// Bodies -> tests a step, as any of the cells has counted them.
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

ChartJson row(const std::string& series, double bodies, double tests) {
    return {{"series", series}, {"bodies", bodies}, {"tests", tests}, {"alone", series == papers_end}};
}

ChartJson values_of(const ReportData& data, Omissions& omitted) {
    ChartJson values = ChartJson::array();
    std::map<double, double> pairs;
    for (const Series& series : measured) {
        for (const auto& [bodies, tests] : tests_of(scene_file(data, series.scene), omitted)) {
            values.push_back(row(series.label, bodies, tests));
            pairs[bodies] = bodies * (bodies - 1) / 2;
        }
    }
    if (values.empty()) return values;
    for (const auto& [bodies, count] : pairs) values.push_back(row(all_pairs, bodies, count));
    values.push_back(row(papers_end, 600, 300));
    return values;
}

ChartJson spec_of(const ChartJson& values) {
    const ChartJson x{{"field", "bodies"},
                      {"type", "quantitative"},
                      {"title", "bodies"},
                      {"scale", log_scale()},
                      {"axis", {{"format", "~s"}, {"tickCount", 6}}}};
    const ChartJson y{{"field", "tests"},
                      {"type", "quantitative"},
                      {"title", "tests a step"},
                      {"scale", log_scale()},
                      {"axis", {{"format", "~s"}, {"tickCount", 8}}}};
    const ChartJson colour{{"field", "series"},
                           {"type", "nominal"},
                           {"title", nullptr},
                           {"scale",
                            {{"domain", {measured[0].label, measured[1].label, all_pairs, papers_end}},
                             {"range", {"#1f77b4", "#ff7f0e", "#7f7f7f", "#d62728"}}}}};
    const ChartJson tooltip =
        ChartJson::array({{{"field", "series"}, {"type", "nominal"}},
                          {{"field", "bodies"}, {"type", "quantitative"}},
                          {{"field", "tests"}, {"type", "quantitative"}, {"format", ".4~g"}}});
    const ChartJson line{{"transform", ChartJson::array({{{"filter", "!datum.alone"}}})},
                         {"mark", {{"type", "line"}, {"strokeWidth", 1.6}}}};
    const ChartJson point{{"mark", {{"type", "point"}, {"filled", true}, {"size", 50}}},
                          {"encoding", {{"tooltip", tooltip}}}};
    return {{"config", chart_config()},
            {"data", {{"values", values}}},
            {"width", 640},
            {"height", 360},
            {"encoding", {{"x", x}, {"y", y}, {"color", colour}}},
            {"layer", ChartJson::array({line, point})}};
}

}  // namespace

Chart paper_bodies_chart(const ReportData& data) {
    Chart chart{
        "paper_figure_5",
        "Figure 5: tests against bodies",
        "How many pairs the broad phase (sweep and prune on boxes) leaves to be tested in a step, at "
        "constant occupancy: with an environment that grows with the number of bodies, and with one that "
        "stays while the bodies shrink. Both axes are logarithmic: a line as steep as the one of all "
        "pairs is quadratic, half as steep is linear. The paper's figure is linear and ends at 600 bodies "
        "and 300 tests.",
        nullptr,
        {},
        {},
        scalability_section};
    Omissions omitted;
    const ChartJson values = values_of(data, omitted);
    if (values.empty()) return chart;
    omitted.write("cell", chart.notes);
    chart.spec = spec_of(values);
    chart.fallback = data_grid(values, {"series", "bodies", "tests"});
    return chart;
}

}  // namespace edgewise::reports
