// SPDX-License-Identifier: MIT
//
// Charts after the figures of the paper. Figure 4: time per query against linear speed, bodies of 8 vertices.
// Coherence depends on the displacement per step divided by the size of the body, so the axis shows that
// ratio. Speeds in metres per second follow from a time step and a size, which the paper does not name.
// Figures 6, 7 and 8: angular speed, bodies of 8, 38 and 386 vertices. The axis is the effective angle per
// step: a rotation beyond half a turn is a smaller one in the opposite direction. The three charts have one
// scale of time, so that they can be laid side by side. Figure 5: tests of pairs against bodies, at constant
// occupancy; the number of tests does not depend on algorithm or table, so a scene is one line. And time and
// memory against the vertices of a body, in panels: coherent queries, cold ones (hill climbing from any
// vertex), bytes of a table.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

constexpr double short_step = 1.0 / 60, long_step = 0.5;  ///< seconds

ChartJson speed_of(const ReportCell& cell) {
    const auto way = parameter_of(cell, "step_in_dimensions");
    if (!way) return nullptr;
    return {
        {"step_in_dimensions", *way}, {"m_s_at_60_Hz", *way / short_step}, {"m_s_at_2_Hz", *way / long_step}};
}

struct PaperFigure {
    int number, vertices;
    double slowest, fastest;  ///< the paper's axis, rad/s
    const char* top;          ///< of its axis of time
    const char* says;
};

constexpr PaperFigure paper_figures[] = {
    {6, 8, 0, 12.57, "7e-5 s", "V-Clip slightly faster, both of comparable complexity"},
    {7, 38, 1, 7, "1e-4 s", "V-Clip consistently faster"},
    {8, 386, 1, 7, "1.2e-3 s, 12 times that of figure 7",
     "Enhanced GJK as with 8 and 38 vertices, V-Clip erratic"}};

/// Returns a cell's place and shape: random orientations are separate, with a shape of their own; angles
/// beyond half a turn fold back over the same axis, as points that no line joins.
ChartJson angle_of(const ReportCell& cell) {
    const double step = parameter_of(cell, "rotation_step").value_or(0);
    const bool random = has_random_orientation(cell);
    ChartJson place{{"angle", random ? random_angle : folded_angle(step)},
                    {"raw_angle", random ? ChartJson(nullptr) : ChartJson(step)},
                    {"larger", random},
                    {"unjoined", random || step > std::numbers::pi + 1e-6}};
    if (random) place["point"] = cell.algorithm + ", random orientations";
    return place;
}

ChartRows angular_rows(const ReportData& data, const PaperFigure& figure) {
    ChartRows rows;
    add_timed_rows(rows, scene_file(data, fmt::format("paper_angular_{}", figure.vertices)).cells, angle_of);
    return rows;
}

/// The slowest of the three figures: where their common scale ends.
double slowest_time(const ReportData& data) {
    double most = 0;
    for (const PaperFigure& figure : paper_figures)
        for (const ChartRows rows = angular_rows(data, figure); const ChartJson& row : rows.values)
            most = std::max(most, row["high"].get<double>());
    return most;
}

/// The paper's axis at 60 and at 2 steps per second; beyond half a turn the axis comes back: all angles up to
/// half a turn are on it.
ChartJson angular_slots_of(const PaperFigure& figure, double most) {
    const auto end = [&](double step) { return std::min(figure.fastest * step, std::numbers::pi); };
    return {{"from_60", figure.slowest / 60},
            {"to_60", end(1.0 / 60)},
            {"from_2", figure.slowest / 2},
            {"to_2", end(0.5)},
            {"most", 1.15 * most}};
}

}  // namespace

Chart paper_linear_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_linear");
    number_chart(chart, 4);
    ChartRows rows;
    add_timed_rows(rows, scene_file(data, "paper_linear_8").cells, speed_of);
    double most = 0;
    for (const ChartJson& row : rows.values) most = std::max(most, row["high"].get<double>());
    return drawn_chart(std::move(chart), data, std::move(rows), {{"most", 1.15 * most}});
}

Chart paper_angular_chart(const ReportData& data, int number) {
    const PaperFigure& figure = paper_figures[number - paper_figures[0].number];
    Chart chart = chart_of_file("paper_angular");
    number_chart(chart, number);
    chart.title = fmt::format(fmt::runtime(chart.title), fmt::arg("number", number),
                              fmt::arg("vertices", figure.vertices));
    chart.how_to_read = fmt::format(fmt::runtime(chart.how_to_read), fmt::arg("slowest", figure.slowest),
                                    fmt::arg("fastest", figure.fastest), fmt::arg("top", figure.top),
                                    fmt::arg("says", figure.says));
    chart.section = number == 6 ? dynamic_section : scalability_section;
    return drawn_chart(std::move(chart), data, angular_rows(data, figure),
                       angular_slots_of(figure, slowest_time(data)));
}

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
        const auto bodies = parameter_of(*cell, "bodies");
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
        // A size is exact.
        add_point(rows.values, curve_json(*cell),
                  {{"measure", of_bytes}, {"high", *size}, {"low", *size}, {"value", *size}});
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

// A user's own scenes from files: time against the number that a scene varies, or against vertices.

namespace {

/// Returns a cell's place on the axis; null, and counted, if its scene does not name it.
ChartJson own_place(const StoredScene& scene, const ReportCell& cell, Omissions& omitted) {
    const auto at = scene.place(cell);
    if (!at) {
        omitted.add("its scene parameters do not hold " + scene.varied);
        return nullptr;
    }
    ChartJson place = ChartJson::object({{"place", *at}});
    if (scene.varied == "rotation_step" && has_random_orientation(cell))
        place = {{"place", random_angle},
                 {"unjoined", true},
                 {"larger", true},
                 {"point", cell.algorithm + ", random orientations"}};
    // Bodies of one shape are joined over what varies; else the shapes are.
    if (!scene.varied.empty()) place["stroke"] = cell.algorithm + " " + cell.table + " " + cell.shape;
    return place;
}

Chart chart_of(const ReportData& data, const StoredScene& scene, const std::string& name) {
    Chart chart = chart_of_file("own_scene");
    const std::string axis = scene.axis_title();
    chart.name = name;
    chart.title =
        fmt::format(fmt::runtime(chart.title), fmt::arg("name", scene.name), fmt::arg("axis", axis));
    chart.how_to_read = fmt::format(fmt::runtime(chart.how_to_read), fmt::arg("note", scene.note));
    ChartRows rows;
    add_timed_rows(rows, scene.cells,
                   [&](const ReportCell& cell) { return own_place(scene, cell, rows.omitted); });
    const bool is_positive =
        std::ranges::all_of(rows.values, [](const ChartJson& row) { return row["place"].get<double>() > 0; });
    const ChartJson slots{{"axis_title", axis},
                          {"scale_of_places", chart.file["scales"][is_positive ? "log" : "linear"]}};
    return drawn_chart(std::move(chart), data, std::move(rows), slots);
}

}  // namespace

std::vector<Chart> own_scene_charts(const ReportData& data) {
    std::vector<Chart> charts;
    std::set<std::string> names;
    for (const StoredScene& scene : scene_files(data)) {
        if (is_of_paper(scene.name)) continue;
        const std::string name = file_name_of("scene_" + scene.name, names);
        names.insert(name);
        charts.push_back(chart_of(data, scene, name));
    }
    return charts;
}

}  // namespace edgewise::reports
